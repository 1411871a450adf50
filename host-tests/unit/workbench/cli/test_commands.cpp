// The program's promises to scripts: exit codes, streams, files, JSON.
#include <regex>

#include "support/workbench/cli_process.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace workbench {
namespace {

using Arguments = std::vector<std::string>;
using nlohmann::json;

TEST_F(CliTest, HelpExplainsEveryCommand) {
  const Outcome help = run({"--help"});
  EXPECT_EQ(help.code, 0);
  for (const std::string command :
       {"identify", "oscillation", "monitor", "report", "simulate"}) {
    EXPECT_NE(help.out.find(command), std::string::npos);
    const Outcome own = run({command, "--help"});
    EXPECT_EQ(own.code, 0);
    EXPECT_NE(own.out.find("Usage: stickband " + command), std::string::npos);
    EXPECT_NE(own.out.find("Examples:"), std::string::npos);
    EXPECT_TRUE(own.err.empty());
    std::istringstream lines(own.out);
    for (std::string line; std::getline(lines, line);) {
      EXPECT_LE(line.size(), 80U) << line;
    }
  }
  EXPECT_EQ(run({"--version"}).out.rfind("stickband ", 0), 0U);
}

TEST_F(CliTest, WrongUsageIsTwo) {
  const std::string csv = simulated("healthy", "1");
  const std::string out = path("x.csv");
  for (const Arguments& arguments : std::vector<Arguments>{
           {},
           {"no-such-command"},
           {"identify"},
           {"identify", csv, "--no-such-option"},
           {"oscillation", csv, csv},
           {"identify", csv, "--ts", "0"},
           {"identify", csv, "--ts", "nan"},
           {"identify", csv, "--ts", "fast"},
           {"identify", csv, "--u", "A.B"},
           {"identify", csv, "--dbc", "a.dbc"},
           {"oscillation", csv, "--column", "t"},
           {"monitor", csv, "--span", "5", "5"},
           {"monitor", csv, "--span", "5"},
           {"report", csv},
           {"report", csv, "-o", csv},
           {"simulate"},
           {"simulate", "healthy", "-o", out},
           {"simulate", "healthy", "--seed", "1"},
           {"simulate", "healthy", "--seed", "-1", "-o", out},
           {"simulate", "healthy", "--seed", "1.5", "-o", out},
           {"simulate", "no-such-scenario", "--seed", "1", "-o", out},
           {"simulate", "healthy", "--seed", "1", "-o", out, "--truth", out},
           {"simulate", "healthy", "--seed", "1", "-o", out, "--dbc-out", "a.dbc"},
       }) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2) << ::testing::PrintToString(arguments);
    EXPECT_TRUE(outcome.out.empty());
    EXPECT_EQ(outcome.err.rfind("stickband: ", 0), 0U);
  }
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(CliTest, ACommandThatIsNearlyRightIsNamed) {
  const std::string csv = simulated("healthy", "1");
  for (const auto& [word, meant] :
       std::vector<std::pair<std::string, std::string>>{{"identfy", "`identify`"},
                                                        {"indentify", "`identify`"},
                                                        {"ladr", "`ladder`"},
                                                        {csv, "`stickband identify "}}) {
    EXPECT_NE(run({word}).err.find("did you mean " + meant), std::string::npos) << word;
  }
  EXPECT_EQ(run({"no-such-command"}).err.find("did you mean"), std::string::npos);
}

TEST_F(CliTest, BadInputIsThreeAndSaysWhere) {
  const std::string text = write("text.csv", "t,u,y\n0,1,2\n1,oops,3\n");
  const std::string empty = write("empty.csv", "");
  const std::string log = write("bus.log", "(1.0) can0 18E#00000000\n");
  const std::string none = path("none.csv");
  const std::string folder = path("");
  for (const auto& [file, where] :
       std::vector<std::pair<std::string, std::string>>{{text, text + ":3:3: "},
                                                        {empty, empty + ":1:1: "},
                                                        {log, log + ":1:1: "},
                                                        {none, none + ": "},
                                                        {folder, folder + ": "}}) {
    for (const char* command : {"identify", "oscillation", "monitor", "report"}) {
      Arguments arguments = {command, file};
      if (arguments[0] == "report") {
        arguments.insert(arguments.end(), {"-o", path("page.html")});
      } else {
        arguments.push_back("--json");
      }
      const Outcome outcome = run(arguments);
      EXPECT_EQ(outcome.code, 3) << command << ' ' << file;
      EXPECT_TRUE(outcome.out.empty());
      EXPECT_NE(outcome.err.find(where), std::string::npos) << outcome.err;
    }
  }
  EXPECT_FALSE(std::filesystem::exists(path("page.html")));
}

TEST_F(CliTest, WhatTheDataCannotTellIsFour) {
  std::string rows = "t,u,y\n";
  for (int i = 0; i < 30; ++i) rows += std::to_string(i) + ",1,2\n";
  const std::string csv = write("short.csv", rows);
  const Outcome scripted = run({"identify", csv, "--json"});
  EXPECT_EQ(scripted.code, 4);
  EXPECT_NE(scripted.err.find("record"), std::string::npos) << scripted.err;
  const json answer = only_json(scripted.out);
  EXPECT_EQ(answer["verdict"], "undecided");
  for (const char* stroke : {"ascending", "descending"}) {
    EXPECT_TRUE(answer["stick_band"][stroke]["value"].is_null());
    EXPECT_TRUE(answer["slip_jump"][stroke]["high"].is_null());
  }
  EXPECT_TRUE(answer["fit_percent"].is_null());
  EXPECT_TRUE(answer["oscillation"]["period_s"].is_null());
  const Outcome human = run({"identify", csv});
  EXPECT_EQ(human.code, 4);
  EXPECT_FALSE(human.out.empty());
  EXPECT_EQ(run({"report", csv, "-o", path("page.html")}).code, 0);
}

TEST_F(CliTest, OutputsThatCannotBeWrittenAreOneAndLeaveNothing) {
  for (const std::string& target : {path("no/such/folder.csv"), path("")}) {
    const Outcome outcome = run({"simulate", "healthy", "--seed", "1", "-o", target});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("cannot write " + target), std::string::npos);
  }
  const Outcome full =
      run({"simulate", "healthy", "--seed", "1", "-o", path("a.csv")}, "/dev/full");
  EXPECT_EQ(full.code, 1);
  EXPECT_NE(full.err.find("standard output"), std::string::npos);
  for (const auto& entry : std::filesystem::directory_iterator(path(""))) {
    EXPECT_EQ(entry.path().string().find(".part"), std::string::npos);
  }
}

TEST_F(CliTest, OutputsReplaceWhatWasThereThroughLinksAndToDevices) {
  write("old.csv", "old");
  std::filesystem::create_symlink(path("old.csv"), path("link.csv"));
  const Outcome linked =
      run({"simulate", "healthy", "--seed", "1", "-o", path("link.csv")});
  EXPECT_EQ(linked.code, 0) << linked.err;
  EXPECT_TRUE(std::filesystem::is_symlink(path("link.csv")));
  EXPECT_EQ(content_of(path("old.csv")).rfind("t,u,y,sp,x\n", 0), 0U);
  const Outcome device = run({"simulate", "healthy", "--seed", "1", "-o", "/dev/null"});
  EXPECT_EQ(device.code, 0);
  EXPECT_FALSE(std::filesystem::is_regular_file("/dev/null"));
}

TEST_F(CliTest, ABrokenPipeIsAnErrorNotACrash) {
  const std::string csv = simulated("healthy", "1");
  const std::string command = std::string("(") + STICKBAND_BIN + " identify " + csv +
                              " 2>/dev/null; echo $? >" + path("code") + ") | true";
  EXPECT_EQ(std::system(command.c_str()), 0);
  const std::string code = content_of(path("code"));
  // The reader may still be there when little is written.
  EXPECT_TRUE(code == "1\n" || code == "0\n" || code == "4\n") << code;
}

TEST_F(CliTest, HumanAnswersFitEightyColumns) {
  const std::string csv = simulated("paper-example-1", "1");
  const std::string other = simulated("paper-example-1", "2");
  for (const Arguments& arguments : std::vector<Arguments>{{"identify", csv},
                                                           {"identify", csv, other},
                                                           {"oscillation", csv},
                                                           {"monitor", csv},
                                                           {"simulate", "--list"}}) {
    std::istringstream lines(run(arguments).out);
    for (std::string line; std::getline(lines, line);)
      EXPECT_LE(line.size(), 80U) << line;
  }
}

TEST_F(CliTest, NoStickBandIsPrintedWithoutItsInterval) {
  const std::string csv = simulated("paper-example-1", "1");
  const std::string monitored = run({"monitor", csv}).out;
  const std::regex band(R"(stick band\s+[0-9.]+\s+\([0-9.]+\s+to\s+[0-9.]+\)\s+)"
                        R"(ascending,\s+[0-9.]+\s+\([0-9.]+\s+to\s+[0-9.]+\)\s+desc)");
  std::size_t told = 0;
  for (std::size_t at = 0; (at = monitored.find("stick band", at)) != std::string::npos;
       ++at) {
    EXPECT_TRUE(std::regex_search(monitored.substr(at, 160), band)) << monitored;
    ++told;
  }
  EXPECT_GE(told, 2U) << monitored;
  const std::string two = run({"identify", csv, simulated("paper-example-1", "2")}).out;
  std::smatch row;
  EXPECT_TRUE(std::regex_search(
      two, row,
      std::regex(R"(\n  2 .* stiction +[0-9.]+ \([0-9.]+ to [0-9.]+\)\n)"
                 R"( {56}[0-9.]+ \([0-9.]+ to [0-9.]+\)\n)")))
      << two;
}

TEST_F(CliTest, SimulateListsEveryScenarioAndRepeatsItself) {
  const Outcome list = run({"simulate", "--list"});
  EXPECT_EQ(list.code, 0);
  for (const ScenarioInfo& scenario : scenarios()) {
    EXPECT_NE(list.out.find(scenario.name), std::string::npos);
  }
  const std::string first = content_of(simulated("stiction", "7"));
  EXPECT_EQ(first, content_of(simulated("stiction", "7")));
  EXPECT_NE(first, content_of(simulated("stiction", "8")));
}

TEST_F(CliTest, CanLogAndCsvGiveTheSameAnswer) {
  const std::string csv = path("loop.csv");
  const std::string log = path("loop.log");
  const std::string truth = path("loop.json");
  ASSERT_EQ(run({"simulate", "paper-example-1", "--seed", "1", "-o", csv, "--candump",
                 log, "--truth", truth})
                .code,
            0);
  EXPECT_EQ(json::parse(content_of(truth))["stick_band"]["ascending"], 5.0);
  const json from_csv = only_json(run({"identify", csv, "--json"}).out);
  const json from_log =
      only_json(run({"identify", log, "--dbc", path("loop.dbc"), "--u", "LoopOP.OP",
                     "--y", "LoopPV.PV", "--sp", "LoopSP.SP", "--json"})
                    .out);
  EXPECT_EQ(from_log["verdict"], from_csv["verdict"]);
  EXPECT_EQ(from_log["recording"]["samples"], from_csv["recording"]["samples"]);
  EXPECT_NEAR(from_log["fit_percent"], from_csv["fit_percent"], 0.5);
}

TEST_F(CliTest, SeveralRecordingsAreCountedTogetherAndEachIsNoted) {
  std::string one = "t,u,y\n";
  std::string other = one;
  for (int i = 0; i < 100; ++i) {
    const std::string values =
        ',' + std::to_string(i * i % 7) + ',' + std::to_string(i * i % 5) + '\n';
    one += std::to_string(i) + values;
    if (i != 40 && i < 80) other += std::to_string(i) + ",1" + values.substr(1);
  }
  write("one.csv", one);
  write("other.csv", other);
  const Outcome both = run({"identify", path("one.csv"), path("other.csv"), "--json"});
  EXPECT_EQ(only_json(both.out)["recording"]["samples"], 180);
  EXPECT_NE(both.err.find("other.csv: "), std::string::npos) << both.err;
}

TEST_F(CliTest, OscillationNeedsOnlyItsColumn) {
  std::string rows = "u\n";
  for (int i = 0; i < 400; ++i) rows += std::to_string(std::sin(i * 0.2)) + '\n';
  const std::string csv = write("u.csv", rows);
  const json report = only_json(run({"oscillation", csv, "--ts", "0.5", "--json"}).out);
  EXPECT_EQ(report["detected"], true);
  EXPECT_NEAR(report["period_s"], 31.4 * 0.5, 0.1);
  EXPECT_NEAR(report["amplitude"], 1, 0.05);
  EXPECT_EQ(run({"oscillation", csv, "--ts", "0.5", "--column", "y"}).code, 3);
}

TEST_F(CliTest, ReportIsOneSelfContainedPage) {
  const std::string csv = path("a <b> & c.csv");
  const std::string truth = path("truth.json");
  ASSERT_EQ(
      run({"simulate", "paper-example-1", "--seed", "1", "-o", csv, "--truth", truth})
          .code,
      0);
  const std::string page_path = path("page.html");
  const Outcome outcome = run({"report", csv, "--truth", truth, "-o", page_path});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(outcome.out.empty());
  const std::string page = content_of(page_path);
  EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0U);
  EXPECT_NE(page.find("a &lt;b&gt; &amp; c.csv"), std::string::npos);
  EXPECT_EQ(page.find("<b> & c"), std::string::npos);
  for (const char* external : {"src=", "href=", "@import", "url("}) {
    EXPECT_EQ(page.find(external), std::string::npos) << external;
  }
  for (const char* nonsense : {"nan", "inf\"", "-inf"}) {
    EXPECT_EQ(page.find(nonsense), std::string::npos) << nonsense;
  }
  EXPECT_EQ(run({"report", csv, "--truth", csv, "-o", page_path}).code, 3);
  EXPECT_EQ(content_of(page_path), page);
}

}  // namespace
}  // namespace workbench
