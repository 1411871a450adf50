// Whether an effect is told from none, and where its interval ends then.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/fit/fit.hpp"
#include "workbench/model/judge/off_profile.hpp"

namespace workbench {
namespace {

// An interval without an end, as a linearised error makes it of two equal lags.
void open_up(const Fit& fit, const Effect& effect, FitIntervals& intervals) {
  for (std::size_t i = 0; i < fit.slots.size(); ++i) {
    const SearchedParameter& parameter = fit.slots[i].parameter;
    if (fit.slots[i].effect != &effect) continue;
    intervals.searched[i] = {parameter.low, parameter.high};
  }
}

Interval told_of(const Fit& fit, const Effect& effect, const FitIntervals& intervals) {
  for (std::size_t i = 0; i < fit.slots.size(); ++i) {
    if (fit.slots[i].effect == &effect) return intervals.searched[i];
  }
  return {};
}

TEST(OffProfile, EndsAnIntervalThatHoldsNoneThoughTheErrorDoesNot) {
  test::SetpointLoop loop;
  loop.delay = 6;
  const Recording recording = simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Effect& dead_time = effects::process_dead_time();
  const auto fit = fitter.extend(fitter.start({}), dead_time, Effort::kThorough);
  ASSERT_TRUE(fit);
  FitIntervals intervals = intervals_of(fitter, *fit);
  open_up(*fit, dead_time, intervals);
  EXPECT_TRUE(excludes_off(fitter, *fit, intervals, dead_time));
  end_by_profile(fitter, *fit, dead_time, intervals);
  const Interval told = told_of(*fit, dead_time, intervals);
  EXPECT_GT(told.low, 3);
  EXPECT_LT(told.low, fit->searched_of(dead_time)[0]);
  EXPECT_GT(told.high, fit->searched_of(dead_time)[0]);
  EXPECT_LT(told.high, 12);
}

TEST(OffProfile, LeavesAnIntervalThatHoldsNoneWithTheError) {
  const Recording recording = test::simulated({});
  const Fitter fitter(recording, Column::y);
  const Effect& lag = effects::process_second_lag();
  const auto fit = fitter.extend(fitter.start({}), lag, Effort::kThorough);
  ASSERT_TRUE(fit);
  FitIntervals intervals = intervals_of(fitter, *fit);
  open_up(*fit, lag, intervals);
  const Interval before = told_of(*fit, lag, intervals);
  EXPECT_FALSE(excludes_off(fitter, *fit, intervals, lag));
  end_by_profile(fitter, *fit, lag, intervals);
  EXPECT_EQ(told_of(*fit, lag, intervals).low, before.low);
}

// (W35) How strong a load is and how slow go together: by sums its gain may be none.
TEST(OffProfile, TellsTheGainOfARecordedLoadByFactors) {
  test::SetpointLoop loop;
  loop.load = [](std::size_t k) {
    return k < 700 ? 0.0 : 20 * (1 - std::exp(-(static_cast<double>(k) - 700) / 400));
  };
  Recording recording = test::simulated(loop);
  std::vector<double> feed(recording.size());
  for (std::size_t k = 700; k < feed.size(); ++k) feed[k] = 4;
  recording.loads = {{"feed", "t/h", feed}};
  const Fitter fitter(recording, Column::y);
  const Effect& effect = effects::disturbance_measured("feed");
  const auto fit = fitter.extend(fitter.start({}), effect, Effort::kThorough);
  ASSERT_TRUE(fit);
  const std::size_t gain = static_cast<std::size_t>(
      std::ranges::find(fit->columns, &effect, &FreeRun::Column::effect) -
      fit->columns.begin());
  ASSERT_LT(gain, fit->columns.size());
  const double value = fit->coefficients[gain];
  FitIntervals intervals = intervals_of(fitter, *fit);
  intervals.solved[gain] = {value - 2 * value, value + 2 * value};
  EXPECT_TRUE(excludes_off(fitter, *fit, intervals, effect));
  EXPECT_TRUE(end_by_profile(fitter, *fit, effect, intervals));
  EXPECT_NEAR(intervals.solved[gain].low, value / std::exp(2), 1e-9);
  EXPECT_NEAR(intervals.solved[gain].high, value * std::exp(2), 1e-9);
  EXPECT_FALSE(holds_off(*fit, intervals, effect));
  intervals.solved[gain] = {value - 1e5 * value, value + 1e5 * value};
  EXPECT_TRUE(end_by_profile(fitter, *fit, effect, intervals));
  EXPECT_NEAR(intervals.solved[gain].high, 1e6 * value, 1e-6 * value);
  EXPECT_FALSE(holds_off(*fit, intervals, effect));
}

// Its jumps may be 0: then it is play, and not none.
TEST(OffProfile, AStemWhoseBandIsNotZeroIsTold) {
  test::SetpointLoop loop;
  loop.valve = test::slipping();
  const Recording recording = test::simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Effect& stem = effects::valve_stiction();
  const auto fit = fitter.extend(fitter.start({}), stem, Effort::kThorough);
  ASSERT_TRUE(fit);
  FitIntervals intervals = intervals_of(fitter, *fit);
  for (Interval& interval : intervals.searched) interval.low = 0;
  ASSERT_EQ(intervals.derived.size(), 2U);
  EXPECT_FALSE(holds_off(*fit, intervals, stem));
  for (DerivedValue& band : intervals.derived) band.interval.low = 0;
  EXPECT_TRUE(holds_off(*fit, intervals, stem));
}

// The data may want play that the walk does not tell from none.
TEST(OffProfile, SaysWhereNoIntervalExcludesNone) {
  const Recording recording = test::simulated({});
  const Fitter fitter(recording, Column::y);
  const Effect& play = effects::valve_backlash();
  const auto fit = fitter.extend(fitter.start({}), play, Effort::kThorough);
  ASSERT_TRUE(fit);
  FitIntervals intervals = intervals_of(fitter, *fit);
  open_up(*fit, play, intervals);
  EXPECT_TRUE(holds_off(*fit, intervals, play));
  for (std::size_t i = 0; i < fit->slots.size(); ++i) {
    if (fit->slots[i].effect == &play) intervals.searched[i].low = fit->p[i] / 2 + 0.1;
  }
  EXPECT_FALSE(holds_off(*fit, intervals, play));
}

}  // namespace
}  // namespace workbench
