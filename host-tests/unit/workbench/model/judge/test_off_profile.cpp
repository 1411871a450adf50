// Whether an effect is told from none, and where its interval ends then.
#include <gtest/gtest.h>

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
