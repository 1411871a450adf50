// Rests put in front of recordings that begin with a step.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "workbench/model/search/ladder.hpp"
#include "workbench/recording/rest_before.hpp"

namespace workbench {
namespace {

// From rest at u = 0 and y = 20: gain 0.5, lag 30 samples.
Recording begun_with_its_step() {
  Recording recording;
  recording.period_s = 2;
  for (int k = 0; k < 200; ++k) {
    recording.t.push_back(2 * k);
    recording.u.push_back(50);
    recording.y.push_back(20 + 25 * (1 - std::exp(-k / 30.0)) + 0.02 * std::sin(7.0 * k));
  }
  recording.manual = {{10, 20}};
  recording.start = "2026-05-03T14:30:00";
  return recording;
}

TEST(RestBefore, MakesAStepTestOfAnAnswerAlone) {
  Recording recording = begun_with_its_step();
  put_rest_before(recording, 0);
  ASSERT_EQ(recording.size(), 200 + kRestSamples);
  EXPECT_DOUBLE_EQ(recording.t.front(), -2.0 * kRestSamples);
  EXPECT_DOUBLE_EQ(recording.t[kRestSamples], 0);
  EXPECT_DOUBLE_EQ(recording.u[kRestSamples - 1], 0);
  EXPECT_DOUBLE_EQ(recording.u[kRestSamples], 50);
  EXPECT_TRUE(recording.sp.empty());
  EXPECT_EQ(recording.manual[0].first, 10 + kRestSamples);
  EXPECT_TRUE(recording.start.empty());
  ASSERT_EQ(recording.resampling.notes.size(), 1u);
  const Model model = start_model(recording, Column::y).model;
  for (const Parameter& parameter : model.process) {
    if (parameter.name == "gain") {
      EXPECT_NEAR(parameter.value, 0.5, 0.02);
    }
    if (parameter.name == "first_lag") {
      EXPECT_NEAR(parameter.value, 60, 2);
    }
  }
}

// Cut off long before it settles: how far y goes shows in where it stood before.
TEST(RestBefore, KnowsWhereTheProcessStood) {
  Recording recording = begun_with_its_step();
  for (const Column column : {Column::t, Column::u, Column::y}) {
    recording.values(column).resize(60);
  }
  recording.manual.clear();
  put_rest_before(recording, 0);
  EXPECT_TRUE(recording.begins_at_rest);
  for (const Parameter& parameter : start_model(recording, Column::y).model.process) {
    if (parameter.name != "gain") continue;
    EXPECT_NEAR(parameter.value, 0.5, 0.01);
    EXPECT_LT(parameter.high - parameter.low, 0.05);
  }
}

TEST(RestBefore, RefusesWhatIsNoStep) {
  Recording recording = begun_with_its_step();
  EXPECT_THROW(put_rest_before(recording, 50), std::invalid_argument);
  recording.u.clear();
  EXPECT_THROW(put_rest_before(recording, 0), std::invalid_argument);
}

TEST(RestBefore, MovesWhatIsSaidOfSamples) {
  Recording recording = begun_with_its_step();
  recording.resampling.gaps = recording.left_out = {{20, 30}};
  put_rest_before(recording, 0);
  EXPECT_EQ(recording.resampling.gaps[0].first, 20 + kRestSamples);
  EXPECT_EQ(recording.left_out[0].last, 30 + kRestSamples);
}

}  // namespace
}  // namespace workbench
