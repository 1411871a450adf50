// model, compare, explain, add and ladder as a user runs them.
#include <gtest/gtest.h>

#include <sstream>

#include "support/workbench/cli_process.hpp"
#include "support/workbench/setpoint_loop.hpp"

namespace workbench {
namespace {

using nlohmann::json;
using Arguments = std::vector<std::string>;

class ModelCli : public CliTest {
 protected:
  // A loop with dead time; returns the path of its CSV file.
  [[nodiscard]] std::string late_loop(std::uint64_t seed = 1000) const {
    test::SetpointLoop loop;
    loop.delay = 6;
    loop.seed = seed;
    const Recording r = test::simulated(loop);
    std::string text = "t,u,y,sp,x\n";
    for (std::size_t k = 0; k < r.size(); ++k) {
      text += std::to_string(r.t[k]) + ',' + std::to_string(r.u[k]) + ',' +
              std::to_string(r.y[k]) + ',' + std::to_string(r.sp[k]) + ',' +
              std::to_string(r.x[k]) + '\n';
    }
    return write("late" + std::to_string(seed) + ".csv", text);
  }
};

TEST_F(ModelCli, FiveCommandsLeadToTheExplainedModel) {
  const std::string csv = late_loop();
  const std::string m = path("m.json");
  const std::string m2 = path("m2.json");
  EXPECT_EQ(run({"model", csv, "-o", m}).code, 0);
  const Outcome compared = run({"compare", csv, "--model", m, "--json"});
  EXPECT_EQ(compared.code, 0);
  EXPECT_FALSE(only_json(compared.out)["residual"]["white"].get<bool>());
  const Outcome explained = run({"explain", csv, "--model", m, "--json"});
  EXPECT_EQ(explained.code, 0);
  EXPECT_TRUE(explained.err.empty());
  const json answer = only_json(explained.out);
  EXPECT_FALSE(answer["explained"].get<bool>());
  EXPECT_EQ(answer["candidates"][0]["effect"], "process.dead_time");
  EXPECT_EQ(answer["candidates"][0]["status"], "accepted");
  const Outcome added =
      run({"add", "process.dead_time", csv, "--model", m, "-o", m2, "--json"});
  EXPECT_EQ(added.code, 0);
  const json step = only_json(added.out);
  EXPECT_LT(step["rmse_validation_after"], step["rmse_validation_before"]);
  EXPECT_NEAR(step["parameters"]["dead_time"]["value"].get<double>(), 6, 0.5);
  const Outcome again = run({"explain", csv, "--model", m2, "--json"});
  EXPECT_TRUE(only_json(again.out)["explained"].get<bool>());
  EXPECT_EQ(json::parse(content_of(m2))["history"].size(), 2u);
}

TEST_F(ModelCli, WithoutAModelEachBeginsWithThatOfModel) {
  const std::string csv = late_loop();
  const std::string m = path("m.json");
  ASSERT_EQ(run({"model", csv, "-o", m}).code, 0);
  for (const Arguments& arguments : std::vector<Arguments>{
           {"compare", csv, "--json"},
           {"explain", csv, "--json"},
           {"add", "process.dead_time", csv, "--json"},
       }) {
    Arguments with = arguments;
    with.insert(with.end(), {"--model", m});
    const Outcome alone = run(arguments);
    EXPECT_EQ(alone.code, 0) << alone.err;
    EXPECT_NE(alone.err.find("no --model"), std::string::npos) << alone.err;
    EXPECT_EQ(alone.out, run(with).out) << ::testing::PrintToString(arguments);
  }
}

TEST_F(ModelCli, WithoutATargetNothingIsKeptAndThatIsSaid) {
  const std::string csv = late_loop();
  for (const Arguments& arguments : std::vector<Arguments>{
           {"model", csv}, {"ladder", csv}, {"add", "process.dead_time", csv}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("Not kept; -o M.json"), std::string::npos) << outcome.out;
  }
}

// A load of y is in a column of its own.
TEST_F(ModelCli, AModelWithAMeasuredLoadAsksForItsColumnItself) {
  test::SetpointLoop loop;
  loop.load = [](std::size_t k) { return k / 70 % 2 == 0 ? 0.0 : 6.0; };
  const Recording r = test::simulated(loop);
  std::string text = "t,u,y,feed\n";
  for (std::size_t k = 0; k < r.size(); ++k) {
    text += std::to_string(r.t[k]) + ',' + std::to_string(r.u[k]) + ',' +
            std::to_string(r.y[k]) + ',' + std::to_string(loop.load(k)) + '\n';
  }
  const std::string csv = write("feed.csv", text);
  const std::string m = path("m.json");
  const std::string m2 = path("m2.json");
  ASSERT_EQ(run({"model", csv, "-o", m}).code, 0);
  ASSERT_EQ(run({"add", "disturbance.measured:feed", csv, "--model", m, "-o", m2}).code,
            0);
  const json asked =
      only_json(run({"compare", csv, "--model", m2, "--load", "feed", "--json"}).out);
  const json unasked = only_json(run({"compare", csv, "--model", m2, "--json"}).out);
  EXPECT_EQ(asked, unasked);
  EXPECT_GT(unasked["fit_percent"].get<double>(), 80);
  const Outcome without = run({"compare", late_loop(), "--model", m2});
  EXPECT_EQ(without.code, 2);
  EXPECT_NE(without.err.find("feed"), std::string::npos);
}

TEST_F(ModelCli, TheLadderSaysTheSameAndAnotherRecordingAgrees) {
  const std::string csv = late_loop();
  const std::string m = path("m.json");
  const Outcome climbed = run({"ladder", csv, "-o", m, "--json"});
  EXPECT_EQ(climbed.code, 0);
  EXPECT_EQ(only_json(climbed.out)["effects"], json({"process.dead_time"}));
  const Outcome other = run({"compare", late_loop(1001), "--model", m, "--json"});
  EXPECT_NEAR(only_json(other.out)["rmse"].get<double>(), 0.2, 0.05);
  const Outcome stem = run({"ladder", csv, "--output", "x", "--json"});
  EXPECT_EQ(only_json(stem.out)["effects"], json::array());
}

TEST_F(ModelCli, TextFitsEightyColumns) {
  const std::string csv = late_loop();
  const std::string m = path("m.json");
  for (const Arguments& arguments : std::vector<Arguments>{
           {"model", csv, "-o", m},
           {"compare", csv, "--model", m},
           {"explain", csv, "--model", m},
           {"ladder", csv},
       }) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line);) {
      EXPECT_LE(line.size(), 84u) << line;
    }
  }
}

TEST_F(ModelCli, WrongUsageIsTwoAndLeavesNoFile) {
  const std::string csv = late_loop();
  const std::string m = path("m.json");
  const std::string out = path("out.json");
  ASSERT_EQ(run({"model", csv, "-o", m, "--with", "process.dead_time"}).code, 0);
  for (const Arguments& arguments : std::vector<Arguments>{
           {"model", csv, "-o", out, "--with", "no.such"},
           {"model", csv, "-o", out, "--with", "sensor.lag,sensor.lag"},
           {"model", csv, "-o", out, "--output", "z"},
           {"compare", csv, "--model", m, "--output", "x"},
           {"add", "no.such", csv, "--model", m, "-o", out},
           {"add", "process.dead_time", csv, "--model", m, "-o", out},
           {"ladder"},
       }) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2) << ::testing::PrintToString(arguments) << outcome.err;
    EXPECT_TRUE(outcome.out.empty());
  }
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(ModelCli, NoCommandReplacesItsRecording) {
  const std::string csv = late_loop();
  const std::string before = content_of(csv);
  const std::string link = path("link.csv");
  std::filesystem::create_symlink(csv, link);
  const std::string m = path("m.json");
  ASSERT_EQ(run({"model", csv, "-o", m}).code, 0);
  for (const std::string& target : {csv, link}) {
    for (const Arguments& arguments : std::vector<Arguments>{
             {"model", csv, "-o", target},
             {"ladder", csv, "-o", target},
             {"add", "process.dead_time", csv, "--model", m, "-o", target},
             {"report", csv, "-o", target},
         }) {
      const Outcome outcome = run(arguments);
      EXPECT_EQ(outcome.code, 2) << ::testing::PrintToString(arguments);
      EXPECT_NE(outcome.err.find("would replace"), std::string::npos) << outcome.err;
    }
  }
  EXPECT_EQ(content_of(csv), before);
  EXPECT_EQ(run({"add", "process.dead_time", csv, "--model", m, "-o", m}).code, 0);
}

TEST_F(ModelCli, BadInputIsThreeAndSaysWhere) {
  const std::string csv = late_loop();
  const std::string m = path("m.json");
  ASSERT_EQ(run({"model", csv, "-o", m}).code, 0);
  json newer = json::parse(content_of(m));
  newer["schema"] = 99;
  for (const std::string& bad :
       {write("text.json", "not json"), write("array.json", "[1]"),
        write("newer.json", newer.dump()), path("none.json"), csv}) {
    const Outcome outcome = run({"explain", csv, "--model", bad});
    EXPECT_EQ(outcome.code, 3) << bad;
    EXPECT_NE(outcome.err.find(bad), std::string::npos) << outcome.err;
  }
  const std::string no_x = write("plain.csv", "t,u,y\n0,1,2\n1,2,3\n2,1,2\n");
  EXPECT_EQ(run({"ladder", no_x, "--output", "x"}).code, 3);
}

TEST_F(ModelCli, AModelOfAnotherLoopIsToldFromOneThatFits) {
  const std::string csv = late_loop();
  const std::string m = path("m.json");
  ASSERT_EQ(run({"model", csv, "-o", m}).code, 0);
  EXPECT_EQ(run({"compare", csv, "--model", m}).out.find("another loop"),
            std::string::npos);
  const std::string other = path("other.csv");
  ASSERT_EQ(run({"simulate", "stiction", "--seed", "5", "-o", other}).code, 0);
  EXPECT_NE(run({"compare", other, "--model", m}).out.find("another loop"),
            std::string::npos);
}

TEST_F(ModelCli, WhatTheDataCannotShowIsFour) {
  const std::string csv = late_loop();
  const std::string m = path("m.json");
  ASSERT_EQ(run({"model", csv, "-o", m}).code, 0);
  const Outcome outcome =
      run({"add", "sensor.quantisation", csv, "--model", m, "-o", path("q.json")});
  EXPECT_EQ(outcome.code, 4) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(path("q.json")));
  EXPECT_EQ(run({"ladder", write("short.csv", "t,u,y\n0,1,2\n1,2,3\n2,1,2\n")}).code, 4);
  std::string rests = "t,u,y\n";
  for (int i = 0; i < 300; ++i) {
    rests += std::to_string(i) + ",50," + std::to_string(i * 7 % 13) + '\n';
  }
  const Outcome at_rest = run({"ladder", write("rests.csv", rests)});
  EXPECT_EQ(at_rest.code, 4);
  EXPECT_NE(at_rest.err.find("the data cannot answer"), std::string::npos);
}

TEST_F(ModelCli, ReportsOnAModelAndReplacesNothingItReads) {
  const std::string csv = late_loop();
  const std::string m = path("m.json");
  const std::string page = path("page.html");
  ASSERT_EQ(run({"model", csv, "-o", m}).code, 0);
  const Outcome outcome = run({"report", csv, "--model", m, "-o", page});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out + outcome.err, "stickband: wrote " + page + "\n");
  EXPECT_LT(content_of(page).find("valve"), content_of(page).find("The model still"));
  EXPECT_NE(content_of(page).find("<h1>The model still lacks dead time.</h1>"),
            std::string::npos);
  const std::string before = content_of(m);
  EXPECT_EQ(run({"report", csv, "--model", m, "-o", m}).code, 2);
  EXPECT_EQ(run({"report", csv, "--model", m, "-o", page, "--output", "x"}).code, 2);
  EXPECT_EQ(run({"report", csv, "-o", page, "--output", "y"}).code, 2);
  EXPECT_EQ(run({"report", csv, "--model", csv, "-o", page}).code, 3);
  EXPECT_EQ(content_of(m), before);
}

}  // namespace
}  // namespace workbench
