// The cases of the hidden-effect benchmark: what their keys promise.
#include <gtest/gtest.h>

#include <cmath>

#include "support/hidden/case.hpp"
#include "support/hidden/textbook.hpp"

namespace hidden {
namespace {

double standard_deviation(const std::vector<double>& values) {
  double sum = 0;
  double squares = 0;
  for (const double v : values) {
    sum += v;
    squares += v * v;
  }
  const auto n = static_cast<double>(values.size());
  return std::sqrt(squares / n - (sum / n) * (sum / n));
}

TEST(HiddenTextbook, LeavesNothingOfATextbookProcess) {
  const HiddenCase clean = make_case({{}, Excitation::kSetpointSteps, 40, 1});
  const Truth& truth = clean.truth;
  const auto sensed = recorded(truth.setup, truth.trace.sensed);
  EXPECT_LT(textbook_misfit(clean.recording.u, sensed), 1e-3 * truth.signal_std);
  EXPECT_NEAR(textbook_misfit(clean.recording.u, clean.recording.y), truth.noise_std,
              0.06 * truth.noise_std);
}

TEST(HiddenCase, EveryEffectMattersUnderEitherExcitation) {
  for (const Effect effect : all_effects()) {
    for (const Excitation excitation :
         {Excitation::kSetpointSteps, Excitation::kLimitCycle}) {
      for (const double ratio : {40.0, 4.0}) {
        const CaseKey key{{effect}, excitation, ratio, 1};
        const HiddenCase one = make_case(key);
        ASSERT_EQ(one.truth.effects.size(), 1u) << describe(key);
        EXPECT_TRUE(one.truth.excited);
        EXPECT_GE(one.truth.effects[0].size, kSmallestSize) << describe(key);
        EXPECT_GE(one.truth.effects[0].events, kFewestEvents) << describe(key);
        // The textbook model's own error says the same: at 40, at least twice the noise.
        const double left = textbook_misfit(one.recording.u, one.recording.y);
        if (ratio == 40.0) {
          EXPECT_GE(left, 1.9 * one.truth.noise_std) << describe(key);
        }
      }
    }
  }
}

TEST(HiddenCase, SignalToNoiseIsWhatWasAskedFor) {
  for (const double ratio : {40.0, 10.0, 4.0}) {
    for (const Effect effect : {Effect::kStiction, Effect::kDeadTime, Effect::kStep}) {
      const HiddenCase one = make_case({{effect}, Excitation::kLimitCycle, ratio, 3});
      const Truth& truth = one.truth;
      EXPECT_NEAR(truth.signal_std / truth.noise_std, ratio, 0.1 * ratio);
      std::vector<double> noise = one.recording.y;
      const auto sensed = recorded(truth.setup, truth.trace.sensed);
      for (std::size_t k = 0; k < noise.size(); ++k) noise[k] -= sensed[k];
      EXPECT_NEAR(standard_deviation(noise), truth.noise_std, 0.08 * truth.noise_std);
    }
  }
}

TEST(HiddenCase, SameKeySameRecordingOtherSeedAnother) {
  const CaseKey key{
      {Effect::kBacklash, Effect::kDeadTime}, Excitation::kSetpointSteps, 10, 5};
  const HiddenCase one = make_case(key);
  EXPECT_EQ(one.recording.y, make_case(key).recording.y);
  CaseKey other = key;
  other.seed = 6;
  EXPECT_NE(one.recording.y, make_case(other).recording.y);
}

TEST(HiddenCase, TruthIsSealed) {
  const HiddenCase one = make_case({{Effect::kStiction}, Excitation::kLimitCycle, 40, 1});
  const HiddenCase two = make_case({{}, Excitation::kQuiet, 4, 2});
  EXPECT_EQ(one.recording.name, two.recording.name);
  for (const HiddenCase* hidden : {&one, &two}) {
    const workbench::Recording& recording = hidden->recording;
    EXPECT_EQ(recording.size(), kSamples);
    EXPECT_EQ(recording.u.size(), kSamples);
    EXPECT_EQ(recording.y.size(), kSamples);
    EXPECT_EQ(recording.sp.size(), kSamples);
    EXPECT_FALSE(recording.has(workbench::Column::x));
    EXPECT_EQ(recording.t[0], 0);
    EXPECT_NEAR(recording.t[10], 10 * recording.period_s, 1e-12);
    EXPECT_TRUE(recording.resampling.notes.empty());
  }
}

TEST(HiddenCase, LimitsBeyondReachChangeNothing) {
  for (const Effect effect :
       {Effect::kSaturation, Effect::kRateLimit, Effect::kOverflow}) {
    const HiddenCase one = make_case({{effect}, Excitation::kSetpointSteps, 40, 2, true});
    EXPECT_FALSE(one.truth.excited);
    const Trace rest = run_loop(without(one.truth.setup, effect), &one.truth.trace.u);
    for (std::size_t k = 0; k < rest.sensed.size(); ++k) {
      ASSERT_NEAR(rest.sensed[k], one.truth.trace.sensed[k], 0.02 * one.truth.noise_std);
    }
  }
}

TEST(HiddenCase, QuietRecordingsShowNothing) {
  for (const Effect effect : {Effect::kStiction, Effect::kDeadTime, Effect::kGainDrift}) {
    for (const double ratio : {40.0, 4.0}) {
      const HiddenCase one = make_case({{effect}, Excitation::kQuiet, ratio, 1});
      EXPECT_FALSE(one.truth.excited);
      EXPECT_NEAR(textbook_misfit(one.recording.u, one.recording.y), one.truth.noise_std,
                  0.08 * one.truth.noise_std);
    }
  }
}

TEST(HiddenCase, StickBandsAreThoseOfTheStem) {
  // In the recording itself: between a turn of u and the stem's answer.
  const HiddenCase one = make_case({{Effect::kStiction}, Excitation::kLimitCycle, 40, 1});
  const auto& valve = one.truth.setup.valve;
  const auto u = recorded(one.truth.setup, one.truth.trace.u);
  const auto stem = recorded(one.truth.setup, one.truth.trace.stem);
  for (std::size_t k = 1; k < u.size(); ++k) {
    if (stem[k] > stem[k - 1] && stem[k - 1] == stem[k > 1 ? k - 2 : 0]) {
      const double least =
          valve.keeps_sliding ? valve.kinetic_ascending : valve.static_ascending;
      EXPECT_GE(u[k] - stem[k - 1], least - 1e-9) << k;
    }
  }
  const auto& parameters = one.truth.effects[0].parameters;
  ASSERT_EQ(parameters.size(), 5u);
  EXPECT_EQ(parameters[0].name, "stick_band_ascending");
  EXPECT_DOUBLE_EQ(parameters[0].value,
                   valve.static_ascending + valve.kinetic_descending);
}

}  // namespace
}  // namespace hidden
