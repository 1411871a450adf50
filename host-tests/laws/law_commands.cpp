// What every command answers on every scenario: one JSON object, complete and in range.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/workbench/cli_process.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace workbench {
namespace {

using nlohmann::json;

void expect_estimate(const json& estimate) {
  for (const char* field : {"value", "low", "high"}) {
    ASSERT_TRUE(estimate.contains(field));
    EXPECT_TRUE(estimate[field].is_null() == estimate["value"].is_null());
  }
  if (estimate["value"].is_null()) return;
  EXPECT_LE(estimate["low"], estimate["value"]);
  EXPECT_LE(estimate["value"], estimate["high"]);
}

void expect_identification(const json& answer) {
  EXPECT_EQ(answer["schema"], 1);
  EXPECT_TRUE(answer["recording"]["samples"].is_number_unsigned());
  EXPECT_GT(answer["recording"]["sample_period_s"], 0);
  EXPECT_TRUE(answer["oscillation"]["detected"].is_boolean());
  EXPECT_TRUE(answer["oscillation"]["regularity"].is_number());
  EXPECT_TRUE(answer["oscillation"]["cycles"].is_number());
  const std::string verdict = answer["verdict"];
  EXPECT_TRUE(verdict == "stiction" || verdict == "backlash" ||
              verdict == "no_stiction" || verdict == "undecided" ||
              verdict == "bad_data");
  EXPECT_FALSE(answer["reason"].get<std::string>().empty());
  ASSERT_TRUE(answer.contains("cause"));
  EXPECT_EQ(answer["cause"] == "valve", verdict == "stiction" || verdict == "backlash");
  for (const char* quantity : {"stick_band", "slip_jump"}) {
    for (const char* stroke : {"ascending", "descending"}) {
      expect_estimate(answer[quantity][stroke]);
    }
  }
  for (const char* field : {"fit_percent", "fit_linear_percent", "aic", "aic_linear"}) {
    ASSERT_TRUE(answer.contains(field));
    EXPECT_TRUE(answer[field].is_number() || answer[field].is_null());
  }
  const json& model = answer["model"];
  EXPECT_EQ(model["a"].size(), model["na"].is_null() ? 0U : model["na"].get<unsigned>());
  EXPECT_EQ(model["b"].size(), model["nb"].is_null() ? 0U : model["nb"].get<unsigned>());
  EXPECT_TRUE(model.contains("nk") && model.contains("d"));
  for (const char* stroke : {"ascending", "descending"}) {
    EXPECT_EQ(model[stroke]["knots"].size(), model[stroke]["x"].size());
  }
  EXPECT_GT(answer["runtime_ms"], 0);
}

// One line for each event, the summary last.
void expect_events(const std::string& text) {
  std::istringstream lines(text);
  json last;
  double t = -HUGE_VAL;
  for (std::string line; std::getline(lines, line);) {
    EXPECT_NE(last["event"], "summary") << "nothing follows the summary";
    last = json::parse(line, nullptr, false);
    ASSERT_TRUE(last.is_object()) << line;
    if (last["event"] == "summary") continue;
    EXPECT_TRUE(last["t"].is_number());
    if (last["event"] == "stiction_raised") {
      expect_estimate(last["stick_band"]["ascending"]);
      expect_estimate(last["stick_band"]["descending"]);
      EXPECT_GT(last["t"], t);
      t = last["t"];
    }
  }
  ASSERT_EQ(last["event"], "summary");
  EXPECT_TRUE(last["verdict"].is_string());
  expect_estimate(last["stick_band"]["ascending"]);
  EXPECT_GT(last["samples"], 0);
  EXPECT_GT(last["ram_bytes"], 0);
  EXPECT_GT(last["worst_step_us"], 0);
  EXPECT_TRUE(last["model_gap"].contains("suspect"));
}

class CliScenario : public CliTest, public ::testing::WithParamInterface<std::string> {};

TEST_P(CliScenario, EveryCommandPrintsOneJsonObject) {
  const Outcome monitored = run({"monitor", simulated(GetParam(), "1"), "--json"});
  EXPECT_TRUE(monitored.code == 0 || monitored.code == 4) << monitored.err;
  expect_events(monitored.out);
  for (const std::string seed : {"1", "2", "3"}) {
    const std::string csv = simulated(GetParam(), seed);
    const Outcome identified = run({"identify", csv, "--json"});
    const json answer = only_json(identified.out);
    expect_identification(answer);
    const bool open = answer["verdict"] == "undecided" || answer["verdict"] == "bad_data";
    EXPECT_EQ(identified.code, open ? 4 : 0);
    EXPECT_EQ(identified.err.empty(), !open) << identified.err;
    for (const char* column : {"u", "y"}) {
      const Outcome detected = run({"oscillation", csv, "--column", column, "--json"});
      EXPECT_EQ(detected.code, 0);
      const json report = only_json(detected.out);
      EXPECT_EQ(report["schema"], 1);
      EXPECT_EQ(report["period_s"].is_number(), report["detected"].get<bool>());
      EXPECT_EQ(report["amplitude"].is_number(), report["detected"].get<bool>());
      EXPECT_TRUE(report["regularity"].is_number());
      EXPECT_TRUE(report["cycles"].is_number_unsigned());
    }
  }
}

std::vector<std::string> scenario_names() {
  std::vector<std::string> names;
  for (const ScenarioInfo& scenario : scenarios()) names.emplace_back(scenario.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Every, CliScenario, ::testing::ValuesIn(scenario_names()),
                         [](const auto& test) {
                           std::string name = test.param;
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

}  // namespace
}  // namespace workbench
