#include "support/workbench/cli_process.hpp"
#include "workbench/screen/screening.hpp"

namespace workbench {
namespace {

using Json = nlohmann::json;

// `stickband screen` as it is used: files in, lines and files out.
class ScreeningTest : public CliTest {
 protected:
  std::string plant(const std::vector<std::string>& options) const {
    std::vector<std::string> arguments{"simulate", "plant",      "--loops",   "4",
                                       "--seed",   "2",          "--samples", "600",
                                       "-o",       path("plant")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome made = run(arguments);
    EXPECT_EQ(made.code, 0) << made.err;
    return path("plant");
  }
  static std::vector<Json> lines_of(const std::string& text) {
    std::vector<Json> out;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) out.push_back(Json::parse(line));
    return out;
  }
};

TEST_F(ScreeningTest, AWideTableSaysWhatIdentifySays) {
  const std::string folder = plant({});
  const Outcome screened = run({"screen", folder, "--json"});
  ASSERT_EQ(screened.code, 0) << screened.err;
  const std::vector<Json> loops = lines_of(screened.out);
  EXPECT_EQ(loops.size(), 4U);
  EXPECT_NE(screened.err.find("of no loop"), std::string::npos);
  for (const Json& loop : loops) {
    if (!loop["error"].is_null()) continue;
    const Outcome one = run({"identify", folder + "/area-001.csv", "--u", loop["u"],
                             "--y", loop["y"], "--json"});
    const Json wanted = only_json(one.out);
    for (const char* name : {"verdict", "stick_band", "slip_jump", "detectable_band"}) {
      EXPECT_EQ(loop[name], wanted[name]) << loop["loop"] << ' ' << name;
    }
    EXPECT_EQ(loop["evidence"]["nats"], wanted["evidence"]["nats"]);
  }
}

TEST_F(ScreeningTest, TheSameForAnyNumberOfThreadsAndFromFiles) {
  const std::string folder = plant({"--files"});
  const Outcome one = run({"screen", folder, "--json", "--threads", "1"});
  const Outcome four = run({"screen", folder, "--json", "--threads", "4"});
  EXPECT_EQ(one.out, four.out);
  EXPECT_EQ(lines_of(one.out).size(), 4U);
}

TEST_F(ScreeningTest, WhatIsAdvisedWorks) {
  const std::string folder = plant({"--files"});
  std::string rows = "date,FT_115,LV_106\n";
  for (int k = 10; k < 60; ++k) {
    rows += "2026-03-04 00:00:" + std::to_string(k) + ',' + std::to_string(k * 3 % 7) +
            ',' + std::to_string(k * 5 % 11) + '\n';
  }
  const std::string csv = write("plant/export.csv", rows);
  write("plant/bus.log", "(1.0) can0 001#0102\n");
  const Outcome screened = run({"screen", csv});
  EXPECT_NE(screened.out.find("--pairs LV_106/FT_115"), std::string::npos)
      << screened.out;
  const std::vector<Json> loops =
      lines_of(run({"screen", csv, "--json", "--pairs", "LV_106/FT_115"}).out);
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_TRUE(loops[0]["error"].is_null()) << loops[0];
  EXPECT_NE(run({"screen", folder}).out.find(" of other kinds passed over: "),
            std::string::npos);
  EXPECT_NE(run({"screen", folder + "/bus.log"}).out.find("\n  stickband identify "),
            std::string::npos);
}

TEST_F(ScreeningTest, ABadFileIsALineAndNoMore) {
  const std::string folder = plant({"--files"});
  write("plant/broken.csv", "this is no table\n");
  const Outcome screened = run({"screen", folder, "--json"});
  EXPECT_EQ(screened.code, 0);
  const std::vector<Json> loops = lines_of(screened.out);
  ASSERT_EQ(loops.size(), 5U);
  EXPECT_EQ(loops.back()["loop"], "broken");
  EXPECT_TRUE(loops.back()["verdict"].is_null());
  EXPECT_NE(loops.back()["error"].get<std::string>().find("expected"), std::string::npos);
  EXPECT_EQ(run({"screen", path("plant/broken.csv")}).code, 3);
  EXPECT_EQ(run({"screen", path("nothing")}).code, 3);
  EXPECT_EQ(run({"screen", folder, "--pairs", "*.OP"}).code, 2);
  EXPECT_EQ(run({"screen", folder, "-o", path("x.xls")}).code, 2);
}

TEST_F(ScreeningTest, GoesOnWhereItWasStopped) {
  const std::string folder = plant({"--files"});
  const std::string result = path("r.jsonl");
  const Outcome whole = run({"screen", folder, "-o", path("w.jsonl")});
  const Outcome first = run({"screen", folder + "/*1001.csv", folder + "/*1002.csv",
                             "--journal", path("j"), "--json"});
  EXPECT_EQ(lines_of(first.out).size(), 2U);
  const Outcome rest = run({"screen", folder, "--journal", path("j"), "-o", result});
  EXPECT_EQ(rest.code, 0);
  EXPECT_NE(rest.err.find("2 loops were finished before"), std::string::npos) << rest.err;
  EXPECT_EQ(content_of(result), content_of(path("w.jsonl")));
  EXPECT_FALSE(std::filesystem::exists(path("w.jsonl.journal")));
}

TEST_F(ScreeningTest, WhenTheTimeIsOverWhatIsDoneIsTheResult) {
  const std::string folder = plant({"--files"});
  const Outcome some =
      run({"screen", folder, "--within", "0.001", "-o", path("r.jsonl")});
  EXPECT_EQ(some.code, 0);
  EXPECT_NE(some.err.find("stopped"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(path("r.jsonl")));
  EXPECT_TRUE(std::filesystem::exists(path("r.jsonl.journal")));
}

TEST_F(ScreeningTest, FilesOfOneLoopAreJudgedTogether) {
  const std::string folder = plant({"--files"});
  const std::string name = std::filesystem::directory_iterator(folder)->path().stem();
  const std::string text = content_of(folder + "/" + name + ".csv");
  std::filesystem::create_directories(path("a/2026-03"));
  std::filesystem::create_directories(path("a/2026-04"));
  write("a/2026-03/FIC-7.csv", text);
  write("a/2026-04/FIC-7.csv", text);
  write("a/FIC-8-1.csv", text);
  write("a/FIC-8-2.csv", text);
  write("a/FIC-9-2.csv", text);
  const std::vector<Json> loops = lines_of(run({"screen", path("a"), "--json"}).out);
  std::map<std::string, std::size_t> files;
  for (const Json& loop : loops) files[loop["loop"]] = loop["files"].size();
  EXPECT_EQ(files, (std::map<std::string, std::size_t>{
                       {"FIC-7", 2}, {"FIC-8", 2}, {"FIC-9-2", 1}}));
  EXPECT_EQ(lines_of(run({"screen", path("a"), "--json", "--apart"}).out).size(), 5U);
}

TEST_F(ScreeningTest, FilesOfOneTagEachArePaired) {
  const std::string folder = plant({"--files"});
  const std::string name = std::filesystem::directory_iterator(folder)->path().filename();
  std::istringstream in(content_of(folder + "/" + name));
  std::string line;
  std::getline(in, line);
  ASSERT_EQ(line.substr(0, 15), "Timestamp,OP,PV");
  std::string u = "Timestamp,Value\n";
  std::string y = u;
  while (std::getline(in, line)) {
    const std::size_t first = line.find(',');
    const std::size_t second = line.find(',', first + 1);
    const std::string t = line.substr(0, first);
    u += t + line.substr(first, second - first) + '\n';
    y += t + line.substr(second, line.find(',', second + 1) - second) + '\n';
  }
  std::filesystem::create_directories(path("tags"));
  write("tags/FIC-7.OP.csv", u);
  write("tags/FIC-7.PV.csv", y);
  write("tags/FIC-8.PV.csv", y);
  const std::vector<Json> loops = lines_of(run({"screen", path("tags"), "--json"}).out);
  ASSERT_EQ(loops.size(), 2U);
  EXPECT_EQ(loops[0]["loop"], "FIC-7");
  EXPECT_EQ(loops[0]["u"], "FIC-7.OP");
  EXPECT_EQ(loops[0]["files"].size(), 2U);
  const Json whole = only_json(run({"identify", folder + "/" + name, "--json"}).out);
  EXPECT_EQ(loops[0]["verdict"], whole["verdict"]);
  EXPECT_EQ(loops[1]["loop"], "FIC-8.PV");
  EXPECT_NE(loops[1]["error"].get<std::string>().find("beside it"), std::string::npos);
  const std::vector<Json> sets = lines_of(run({"screen", path("tags"), "--plan"}).out);
  EXPECT_EQ(sets.size(), 2U);
  const Outcome nowhere = run({"screen", path("tagz"), "--plan"});
  EXPECT_EQ(nowhere.code, 3);
  EXPECT_NE(nowhere.err.find("tagz: expected a file or folder"), std::string::npos);
}

TEST_F(ScreeningTest, HoweverShortTheTimeItGetsOn) {
  const std::vector<std::string> files = {"--files"};
  const std::vector<std::string> wide_table;
  for (const std::vector<std::string>& kind : {files, wide_table}) {
    std::filesystem::remove_all(path("plant"));
    std::filesystem::remove(path("j"));
    const std::string folder = plant(kind);
    std::size_t done = 0;
    for (int k = 0; k < 5 && done < 4; ++k) {
      const Outcome part = run({"screen", folder, "--journal", path("j"), "--within",
                                "1e-6", "--json", "--threads", "1"});
      EXPECT_EQ(part.code, 0);
      const std::size_t now = lines_of(part.out).size();
      EXPECT_GT(now, done);
      done = now;
    }
    EXPECT_EQ(done, 4U);
  }
}

TEST_F(ScreeningTest, ThePlanNamesSetsThatShareNoLoop) {
  const std::string folder = plant({"--files"});
  std::filesystem::create_directories(folder + "/2026-04");
  const std::string name = std::filesystem::directory_iterator(folder)->path().filename();
  const std::vector<Json> sets = lines_of(run({"screen", folder, "--plan"}).out);
  EXPECT_EQ(sets.size(), 4U);
  for (const Json& set : sets) EXPECT_EQ(set["loops"], 1);
}

TEST_F(ScreeningTest, ABadRowOfAWideTableIsToldOfAllItsLoops) {
  const std::string folder = plant({});
  std::string text = content_of(folder + "/area-001.csv");
  text.insert(text.find('\n', text.size() / 2) + 1, "\"unclosed\n");
  write("plant/area-001.csv", text);
  for (int i = 0; i < 2; ++i) {
    const Outcome screened = run({"screen", folder, "--json", "--journal", path("j")});
    const std::vector<Json> loops = lines_of(screened.out);
    ASSERT_FALSE(loops.empty());
    for (const Json& loop : loops) {
      EXPECT_FALSE(loop["error"].is_null()) << i << ' ' << loop.dump();
      EXPECT_NE(loop["error"], "");
    }
  }
}

TEST_F(ScreeningTest, WhatCouldNotBeReadIsReadNextTime) {
  const std::string folder = plant({"--files"});
  const std::string text = content_of(folder + "/FIC-1002.csv");
  ASSERT_FALSE(text.empty());
  write("plant/FIC-1002.csv", "this is no table\n");
  const std::vector<std::string> command = {"screen", folder, "--json", "--journal",
                                            path("j")};
  const auto errors = [&] {
    int count = 0;
    for (const Json& loop : lines_of(run(command).out)) count += !loop["error"].is_null();
    return count;
  };
  EXPECT_EQ(errors(), 1);
  EXPECT_EQ(errors(), 1) << "said again";
  write("plant/FIC-1002.csv", text);
  EXPECT_EQ(errors(), 0);
}

TEST_F(ScreeningTest, FilesOfOneLoopHaveTheSameUnits) {
  const std::string folder = plant({"--files"});
  const std::string text = content_of(folder + "/FIC-1002.csv");
  const std::string rows = text.substr(text.find('\n'));
  std::filesystem::create_directories(path("units"));
  write("units/FIC7_2024-01.csv", "t [s],u [%],y [m3/h],sp [m3/h]" + rows);
  write("units/FIC7_2024-02.csv", "t [s],u [mA],y [m3/h],sp [m3/h]" + rows);
  const std::vector<Json> loops = lines_of(run({"screen", path("units"), "--json"}).out);
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_NE(loops[0]["error"].dump().find("mA"), std::string::npos) << loops[0].dump();
}

TEST_F(ScreeningTest, ReplacesNoRecordingThatItReads) {
  const std::string folder = plant({"--files"});
  const std::string file = folder + "/FIC-1002.csv";
  EXPECT_EQ(run({"screen", file, "-o", file}).code, 2);
  EXPECT_TRUE(std::filesystem::file_size(file) > 1000);
}

}  // namespace
}  // namespace workbench
