// Several recordings of one loop on the command line: one model of all, and --validate.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/workbench/cli_process.hpp"
#include "support/workbench/setpoint_loop.hpp"

namespace workbench {
namespace {

using nlohmann::json;
using test::SetpointLoop;

class RecordingsCli : public CliTest {
 protected:
  // Samples [first, last) as a CSV file.
  [[nodiscard]] std::string csv(const char* name, const Recording& r,
                                std::size_t first = 0, std::size_t last = 1U << 30U,
                                const char* header = "t,u,y") const {
    std::string text = std::string(header) + '\n';
    for (std::size_t k = first; k < std::min(last, r.size()); ++k) {
      text += std::to_string(r.t[k]) + ',' + std::to_string(r.u[k]) + ',' +
              std::to_string(r.y[k]) + '\n';
    }
    return write(name, text);
  }
  [[nodiscard]] static Recording loop(std::uint64_t seed, std::size_t delay = 0,
                                      double backlash = 0) {
    SetpointLoop out;
    out.seed = seed;
    out.delay = delay;
    if (backlash > 0) out.valve = test::backlash(backlash);
    return test::simulated(out);
  }
  static double value(const json& parameters, const char* name) {
    return parameters.at(name).at("value").get<double>();
  }
};

TEST_F(RecordingsCli, ThePeriodMayHaveAUnit) {
  const std::string file = csv("loop.csv", loop(1000, 6));
  for (const char* ts : {"500ms", "0.5 s", "0.5"}) {
    const json out = json::parse(run({"identify", file, "--ts", ts, "--json"}).out);
    EXPECT_EQ(out["recording"]["sample_period_s"], 0.5) << ts;
  }
  for (const char* ts : {"5 bar", "s", "-5ms"}) {
    EXPECT_EQ(run({"identify", file, "--ts", ts}).code, 2) << ts;
  }
}

TEST_F(RecordingsCli, TwoHalvesGiveTheModelOfTheWhole) {
  const Recording whole = loop(1000, 6);
  const std::string all = csv("all.csv", whole);
  const std::string a = csv("a.csv", whole, 0, 600);
  const std::string b = csv("b.csv", whole, 600);
  const std::string one = path("one.json");
  const std::string two = path("two.json");
  EXPECT_EQ(run({"model", all, "--with", "process.dead_time", "-o", one}).code, 0);
  EXPECT_EQ(run({"model", a, b, "--with", "process.dead_time", "-o", two}).code, 0);
  const json left = json::parse(content_of(one));
  const json right = json::parse(content_of(two));
  const auto within = [](const json& inner, const json& outer) {
    EXPECT_LE(outer["low"], inner["value"]);
    EXPECT_GE(outer["high"], inner["value"]);
  };
  for (const char* name : {"gain", "first_lag", "offset"}) {
    within(right["process"][name], left["process"][name]);
  }
  within(right["effects"][0]["parameters"]["dead_time"],
         left["effects"][0]["parameters"]["dead_time"]);
  EXPECT_EQ(right["recording"]["samples"], whole.size());
  const json compared = only_json(run({"compare", a, b, "--model", two, "--json"}).out);
  ASSERT_EQ(compared["recordings"].size(), 2U);
  EXPECT_EQ(compared["recordings"][1]["file"], "b.csv");
  EXPECT_NEAR(compared["recordings"][1]["rmse"].get<double>(), 0.2, 0.05);
}

TEST_F(RecordingsCli, ExplainFindsWhatShowsInTheSecondOneAlone) {
  // u hardly turns around in the first recording, so that play does not show.
  Recording ramp;
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, 0.2);
  double z = 0;
  for (std::size_t k = 0; k < 600; ++k) {
    const double u = 40 + 0.03 * static_cast<double>(k);
    ramp.t.push_back(static_cast<double>(k));
    ramp.u.push_back(u);
    ramp.y.push_back(50 + 2 * z + noise(random));
    z += (1 - std::exp(-1.0 / 20)) * (u - 2 - 50 - z);
  }
  const std::string a = csv("a.csv", ramp);
  const std::string b = csv("b.csv", loop(5, 0, 4));
  const json alone = only_json(run({"ladder", a, "--json"}).out);
  EXPECT_EQ(alone["effects"], json::array());
  const json both = only_json(run({"ladder", a, b, "--json"}).out);
  ASSERT_EQ(both["effects"].size(), 1U) << both.dump();
  EXPECT_EQ(both["effects"][0], "valve.backlash");
}

TEST_F(RecordingsCli, WhatJudgesCatchesAModelThatSaysTooMuch) {
  // A load step, and a spurious drift of the gain fitted to it, help on the first day
  // only.
  SetpointLoop monday;
  monday.load = [](std::size_t k) { return 0.004 * static_cast<double>(k); };
  const std::string a = csv("a.csv", test::simulated(monday));
  const std::string b = csv("b.csv", loop(7));
  const std::string m = path("m.json");
  const json rich = only_json(run({"model", a, "--with", "process.nonlinear_gain",
                                   "--validate", b, "-o", m, "--json"})
                                  .out);
  ASSERT_EQ(rich["recordings"].size(), 2U);
  EXPECT_TRUE(rich["recordings"][1]["judges"].get<bool>());
  EXPECT_GT(rich["recordings"][1]["rmse"].get<double>(),
            1.5 * rich["recordings"][0]["rmse"].get<double>());
  const json ladder = only_json(run({"ladder", a, "--validate", b, "--json"}).out);
  EXPECT_EQ(ladder["effects"], json::array());
  bool told = false;
  for (const json& candidate : ladder["left"]) {
    if (candidate["effect"] != "disturbance.ramp") continue;
    told = true;
    EXPECT_EQ(candidate["status"], "undecided");
    EXPECT_NE(candidate["evidence"].get<std::string>().find("b.csv"), std::string::npos);
  }
  EXPECT_TRUE(told);
}

TEST_F(RecordingsCli, WhatJudgesConfirmsWhatIsThere) {
  const std::string a = csv("a.csv", loop(1000, 6));
  const std::string b = csv("b.csv", loop(1001, 6));
  const std::string m = path("m.json");
  const json ladder =
      only_json(run({"ladder", a, "--validate", b, "-o", m, "--json"}).out);
  EXPECT_EQ(ladder["effects"], json({"process.dead_time"}));
  EXPECT_EQ(ladder["rmse_validation"], ladder["recordings"][1]["rmse"]);
  const json compared = only_json(run({"compare", b, "--model", m, "--json"}).out);
  EXPECT_NEAR(compared["rmse"].get<double>(), ladder["rmse_validation"].get<double>(),
              1e-6);
}

TEST_F(RecordingsCli, RefusesWhatIsNotOfOneLoop) {
  const Recording r = loop(1000);
  const std::string a = csv("a.csv", r, 0, 400, "t,u [%],y [m3/h]");
  const std::string b = csv("b.csv", r, 400, 800, "t,u [%],y [l/s]");
  const std::string m = path("m.json");
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"model", a, b, "-o", m},
                                             {"ladder", a, "--validate", b},
                                             {"identify", a, b}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 3) << arguments[0];
    EXPECT_NE(outcome.err.find("a.csv"), std::string::npos);
    EXPECT_NE(outcome.err.find("b.csv"), std::string::npos);
    EXPECT_NE(outcome.err.find("l/s"), std::string::npos);
  }
  EXPECT_EQ(run({"ladder", a, a}).code, 2);
  EXPECT_EQ(run({"ladder", a, "--validate", a}).code, 2);
}

TEST_F(RecordingsCli, AGapBeginsANewPiece) {
  const Recording r = loop(1000, 6);
  std::string text = "t,u,y\n";
  for (std::size_t k = 0; k < r.size(); ++k) {
    if (k >= 500 && k < 640) continue;
    text += std::to_string(r.t[k]) + ',' + std::to_string(r.u[k]) + ',' +
            std::to_string(r.y[k]) + '\n';
  }
  const std::string gap = write("gap.csv", text);
  const Outcome outcome = run({"ladder", gap, "--json"});
  EXPECT_NE(outcome.err.find("left out"), std::string::npos);
  const json ladder = only_json(outcome.out);
  EXPECT_EQ(ladder["effects"], json({"process.dead_time"}));
  EXPECT_NEAR(ladder["rmse"].get<double>(), 0.2, 0.02);
}

TEST_F(RecordingsCli, SaysWhyVerdictAndModelDiffer) {
  const std::string a = csv("a.csv", loop(1000, 6));
  const json ladder = only_json(run({"ladder", a, "--json"}).out);
  ASSERT_TRUE(ladder.contains("identify"));
  EXPECT_TRUE(ladder["identify"]["verdict"].is_string());
  EXPECT_TRUE(ladder["identify"]["differs"].is_null());
}

}  // namespace
}  // namespace workbench
