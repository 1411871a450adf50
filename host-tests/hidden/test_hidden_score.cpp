// How answers are judged, on answers written by hand, and which cases there are.
#include <gtest/gtest.h>

#include <limits>

#include "hidden/case_list.hpp"
#include "hidden/outcome.hpp"
#include "hidden/tables.hpp"

namespace hidden {
namespace {

Outcome answer(std::vector<Effect> hidden_effects, std::vector<AddedEffect> added) {
  Outcome outcome;
  outcome.key.effects = std::move(hidden_effects);
  outcome.named.added = std::move(added);
  if (!outcome.named.added.empty()) outcome.named.first = {outcome.named.added[0]};
  outcome.named.rmse_validation = 1.05;
  outcome.true_model_rmse = 1;
  return outcome;
}

TEST(HiddenScore, TheFirstNameOrItsGroupCounts) {
  const auto right =
      answer({Effect::kSecondLag}, {{"sensor.lag", {"process.second_lag"}}});
  EXPECT_TRUE(right_first(right));
  EXPECT_FALSE(wrong_first(right));
  EXPECT_EQ(needless(right), 0);

  const auto late = answer({Effect::kSecondLag},
                           {{"process.dead_time", {}}, {"process.second_lag", {}}});
  EXPECT_FALSE(right_first(late));
  EXPECT_TRUE(wrong_first(late));
  EXPECT_EQ(hidden_found(late), 1);
  EXPECT_EQ(needless(late), 1);

  const auto silent = answer({Effect::kSecondLag}, {});
  EXPECT_FALSE(right_first(silent));
  EXPECT_FALSE(wrong_first(silent));
}

TEST(HiddenScore, TwoEffectsNeedTwoNames) {
  const std::vector<Effect> both{Effect::kSecondLag, Effect::kSensorLag};
  // One group for both is one name.
  EXPECT_EQ(hidden_found(answer(both, {{"sensor.lag", {"process.second_lag"}}})), 1);
  // The only assignment that names both gives the group to the second lag.
  const auto crossed =
      answer(both, {{"sensor.lag", {"process.second_lag"}}, {"sensor.lag", {}}});
  EXPECT_EQ(hidden_found(crossed), 2);
  EXPECT_EQ(needless(crossed), 0);
  EXPECT_EQ(needless(answer(both, {{"valve.backlash", {}}})), 1);
  EXPECT_EQ(needless(answer({}, {{"valve.backlash", {}}})), 1);
}

TEST(HiddenScore, IntervalsIncludeTheirEnds) {
  EXPECT_TRUE((Interval{"", 2, 2, 3}.covers()));
  EXPECT_TRUE((Interval{"", 2, 1, 2}.covers()));
  EXPECT_FALSE((Interval{"", 2, 2.001, 3}.covers()));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE((Interval{"", 2, nan, nan}.covers()));
}

TEST(HiddenScore, TablesCountWhatWasAnswered) {
  Results results;
  results.one_effect = {
      answer({Effect::kDeadTime}, {{"process.dead_time", {}}}),
      answer({Effect::kDeadTime}, {{"process.second_lag", {"process.dead_time"}}}),
      answer({Effect::kDeadTime}, {{"valve.backlash", {}}}),
      answer({Effect::kDeadTime}, {})};
  const std::string text = tables_of(results);
  const auto has = [&](const char* line) {
    EXPECT_NE(text.find(line), std::string::npos) << line << "\n" << text;
  };
  has("| right effect or its group named first | 50.0 | – | – | 50.0 |");
  has("| the effect itself named first | 25.0 |");
  has("| wrong name first | 25.0 |");
  has("| nothing named | 25.0 |");
  has("| names in the group, mean | 1.50 |");
  has("| ratio at most 1.10, % | 100.0 |");
  has("| process.dead_time | steps | 4 | 50.0 | – | – | 1 | valve.backlash 1 |");
  EXPECT_EQ(text.find("Two hidden"), std::string::npos);
}

TEST(HiddenScore, CaseListHasEveryCorner) {
  const Seeds seeds{1, 2};
  EXPECT_EQ(one_effect(seeds).size(), std::size_t{kEffects} * 2 * 3 * 2);
  EXPECT_EQ(clean(seeds, 500).size(), 500u);
  EXPECT_EQ(not_excited(seeds).size(), (17u + 3) * 3 * 2);
  for (const CaseKey& key : two_effects({1000, 1})) {
    EXPECT_EQ(key.effects.size(), 2u);
    EXPECT_EQ(key.seed, 1000u);
  }
}

TEST(HiddenScore, EveryPairHasALoopThatShowsBoth) {
  for (const CaseKey& key : two_effects({1, 2})) {
    EXPECT_NO_THROW(static_cast<void>(make_case(key))) << describe(key);
  }
}

TEST(HiddenScore, KeysAreReadAsTheyAreDescribed) {
  const auto key = parse_key("valve.stiction+process.dead_time", "cycle", "10", "7");
  ASSERT_TRUE(key.has_value());
  EXPECT_EQ(describe(*key), "valve.stiction+process.dead_time cycle 10 seed 7");
  EXPECT_EQ(describe(parse_key("clean", "quiet", "4", "1").value()),
            "clean quiet 4 seed 1");
  EXPECT_TRUE(parse_key("process.overflow", "beyond", "4", "1")->beyond_reach);
  EXPECT_FALSE(parse_key("valve.friction", "cycle", "10", "7").has_value());
  EXPECT_FALSE(parse_key("clean", "rest", "10", "7").has_value());
  EXPECT_FALSE(parse_key("clean", "steps", "ten", "7").has_value());
}

}  // namespace
}  // namespace hidden
