// Model files: the round trip, and what is refused.
#include <gtest/gtest.h>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/model/judge/compare.hpp"
#include "workbench/model/search/ladder.hpp"
#include "workbench/model/tell/explanation_json.hpp"
#include "workbench/model/tell/model_json.hpp"
#include "workbench/recording/input_error.hpp"

namespace workbench {
namespace {

Model model() {
  test::SetpointLoop loop;
  loop.samples = 400;
  loop.delay = 5;
  return start_model(test::simulated(loop), Column::y, {"process.dead_time"}).model;
}

TEST(ModelJson, SurvivesTheRoundTrip) {
  const Model before = model();
  const std::string text = model_json(before).dump(2);
  const Model after = parse_model(text, "m.json");
  EXPECT_EQ(model_json(after).dump(2), text);
  EXPECT_EQ(after.effect_codes(), before.effect_codes());
  test::SetpointLoop loop;
  loop.samples = 400;
  loop.delay = 5;
  const Recording recording = test::simulated(loop);
  EXPECT_NEAR(compare(recording, after).quality.rmse, before.history.back().rmse_after,
              1e-9);
}

// Told where it is so.
TEST(ModelJson, KeepsWhatIsUncertain) {
  Model uncertain = model();
  ASSERT_FALSE(uncertain.effects[0].untold);
  EXPECT_FALSE(term_json(uncertain.effects[0]).contains("untold"));
  uncertain.effects[0].untold = true;
  EXPECT_TRUE(parse_model(model_json(uncertain).dump(), "m.json").effects[0].untold);
}

// The loads of a model are those of the recording it was fitted to, which another one at
// the same times, with the same first and last u, is not.
TEST(ModelJson, KnowsItsRecordingByItsSamples) {
  const std::vector<double> levels = {40, 60, 50, 40};
  Recording with_load = test::stepped(levels, [](double u) { return u; });
  const Recording without = with_load;
  for (std::size_t k = 300; k < with_load.size(); ++k) with_load.y[k] += 9;
  const Model fitted = start_model(with_load, Column::y, {"disturbance.step"}).model;
  auto json = model_json(fitted);
  const Model again = parse_model(json.dump(), "m.json");
  EXPECT_TRUE(compare(with_load, again).stayed_behind.empty());
  const Comparison other = compare(without, again);
  EXPECT_EQ(other.stayed_behind, std::vector<std::string>{"disturbance.step"});
  EXPECT_GT(other.quality.fit_percent, 95);
  json["recording"].erase("fingerprint");
  EXPECT_TRUE(compare(without, parse_model(json.dump(), "m.json")).stayed_behind.empty());
  json["recording"]["fingerprint"] = 3;
  EXPECT_THROW((void)parse_model(json.dump(), "m.json"), InputError);
}

// A load that stays, without what goes with one that passes.
TEST(ModelJson, AFormThatTheFileLacksIsNotTaken) {
  Recording r =
      test::stepped(std::vector<double>{40, 60, 50, 40}, [](double u) { return u; });
  for (std::size_t k = 300; k < r.size(); ++k) r.y[k] += 9;
  const Model fitted = start_model(r, Column::y, {"disturbance.step"}).model;
  auto json = model_json(fitted);
  for (const char* name : {"passing", "end"}) {
    ASSERT_TRUE(json["effects"][0]["parameters"].contains(name));
    json["effects"][0]["parameters"].erase(name);
  }
  const Model fewer = parse_model(json.dump(), "m.json");
  EXPECT_NEAR(compare(r, fewer).quality.rmse, compare(r, fitted).quality.rmse, 1e-9);
  json["effects"][0]["parameters"].erase("time");
  const Model broken = parse_model(json.dump(), "m.json");
  EXPECT_THROW((void)compare(r, broken), InputError);
}

// Only an upper limit shows: the lower one is told as absent, and cuts off nothing where
// another recording has u below all of the first.
TEST(ModelJson, ALimitThatWasNotReachedIsNoneElsewhere) {
  const auto stops = [](double u) { return std::min(u, 56.0); };
  const std::vector<double> levels = {45, 62, 50, 65, 42, 60, 48, 64};
  const Model fitted =
      start_model(test::stepped(levels, stops), Column::y, {"valve.saturation"}).model;
  const Parameter& lower = fitted.effects[0].parameters[0];
  const Parameter& upper = fitted.effects[0].parameters[1];
  EXPECT_EQ(lower.value, lower.bound_low);
  EXPECT_NEAR(upper.value, 56, 0.5);
  const std::vector<double> below = {40, 20, 30, 10, 25, 60, 15, 40};
  const Comparison other = compare(test::stepped(below, stops), fitted);
  EXPECT_GT(other.quality.fit_percent, 95);
}

TEST(ModelJson, ACharacteristicListsItsCurveAndItsKind) {
  std::vector<Parameter> list;
  for (const double value : {2.0, 20.0, 80.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}) {
    list.push_back({.name = "p" + std::to_string(list.size()), .value = value});
  }
  const auto curved = effect_json("valve.characteristic", false, list);
  EXPECT_EQ(curved["kind"], "equal_percentage");
  EXPECT_EQ(curved["curve"][0][0], 20.0);
  EXPECT_FALSE(effect_json("valve.saturation", false, list).contains("curve"));
  list.resize(2);  // a file that somebody edited
  EXPECT_FALSE(effect_json("valve.characteristic", false, list).contains("curve"));
}

// Each edit of a good file is refused with a message that names the key.
TEST(ModelJson, RefusesWhatIsNotAModelAndSaysWhere) {
  const auto good = model_json(model());
  const auto refused = [&](const char* key, auto edit) {
    auto bad = good;
    edit(bad);
    try {
      (void)parse_model(bad.dump(), "m.json");
      ADD_FAILURE() << key << " was accepted";
    } catch (const InputError& error) {
      const std::string text = error.what();
      EXPECT_EQ(text.rfind("m.json: expected ", 0), 0u) << text;
      EXPECT_NE(text.find(key), std::string::npos) << text;
      EXPECT_NE(text.find("stickband"), std::string::npos) << text;
    }
  };
  refused("schema", [](auto& j) { j["schema"] = 2; });
  refused("kind", [](auto& j) { j["kind"] = "recipe"; });
  refused("output", [](auto& j) { j["output"] = "z"; });
  refused("process", [](auto& j) { j.erase("process"); });
  refused("process.gain.value", [](auto& j) { j["process"]["gain"]["value"] = "two"; });
  refused("process.first_lag.value",
          [](auto& j) { j["process"]["first_lag"]["value"] = -5; });
  refused("process.gain.value", [](auto& j) { j["process"]["gain"]["value"] = 1e300; });
  refused("effects[0].parameters.dead_time.value",
          [](auto& j) { j["effects"][0]["parameters"]["dead_time"]["value"] = 1e6; });
  refused("process.gain.bounds", [](auto& j) { j["process"]["gain"]["bounds"] = {1}; });
  refused("effects[0].effect", [](auto& j) { j["effects"][0]["effect"] = "no.such"; });
  refused("effects[1].effect", [](auto& j) { j["effects"].push_back(j["effects"][0]); });
  refused("recording.samples", [](auto& j) { j["recording"]["samples"] = -1; });
  refused("history", [](auto& j) { j["history"] = 3; });
  for (const char* text : {"", "{", "[]", "null", "{\"schema\":1}", "t,u,y\n1,2,3\n"}) {
    EXPECT_THROW((void)parse_model(text, "m.json"), InputError) << text;
  }
}

// Bounds that somebody edited, too.
TEST(ModelJson, ASimulationOfImpossibleTimesStaysWithinItsSamples) {
  test::SetpointLoop loop;
  loop.samples = 400;
  const Recording recording = test::simulated(loop);
  Model lag = model();
  Parameter& first_lag = lag.process[1];
  ASSERT_EQ(first_lag.name, "first_lag");
  first_lag.value = -5;
  EXPECT_THROW((void)compare(recording, lag), InputError);
  Model late = model();
  Parameter& dead_time = late.effects[0].parameters[0];
  for (const double value : {-5.0, 1e6, 1e300}) {
    dead_time.value = value;
    EXPECT_EQ(compare(recording, late).simulated.size(), recording.size()) << value;
  }
}

TEST(ModelJson, AMissingParameterIsNoticedWhenTheModelIsUsed) {
  auto json = model_json(model());
  json["effects"][0]["parameters"].erase("dead_time");
  const Model bad = parse_model(json.dump(), "m.json");
  EXPECT_THROW((void)compare(test::simulated({}), bad), InputError);
}

TEST(ExplanationJson, HasTheKeysOfTheContract) {
  const Recording recording = test::simulated({});
  const LadderResult ladder = run_ladder(recording);
  const auto climbed = ladder_json(ladder);
  for (const char* key : {"schema", "steps", "effects", "explained", "rmse_validation"}) {
    EXPECT_TRUE(climbed.contains(key)) << key;
  }
  const auto explanation = explanation_json(ladder.last);
  ASSERT_FALSE(explanation["candidates"].empty());
  for (const char* key :
       {"effect", "status", "rmse_validation_before", "rmse_validation_after",
        "error_reduction_percent", "p_value", "indistinguishable_from", "would_split",
        "evidence", "parameters"}) {
    EXPECT_TRUE(explanation["candidates"][0].contains(key)) << key;
  }
  const auto compared = comparison_json(compare(recording, ladder.model));
  for (const char* key : {"schema", "effects", "fit_percent", "rmse", "rmse_validation",
                          "residual", "failures"}) {
    EXPECT_TRUE(compared.contains(key)) << key;
  }
  EXPECT_TRUE(compared["residual"]["white"].is_boolean());
  const auto added =
      added_json(add_effect(recording, ladder.model, "process.dead_time").model);
  EXPECT_EQ(added["effect"], "process.dead_time");
  EXPECT_TRUE(added["parameters"].contains("dead_time"));
  Model without = ladder.model;
  without.history.push_back({"-sensor.lag", "loop.csv", 1, 2, 3, 4});
  const auto removed = removed_json(without);
  EXPECT_EQ(removed["effect"], "sensor.lag");
  EXPECT_EQ(removed["rmse_validation_after"], 4);
  EXPECT_EQ(removed["effects"], nlohmann::ordered_json(ladder.model.effect_codes()));
}

}  // namespace
}  // namespace workbench
