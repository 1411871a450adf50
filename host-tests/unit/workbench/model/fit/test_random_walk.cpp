// The walk against a Gaussian error whose deviations are known.
#include <gtest/gtest.h>

#include <cmath>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/fit/fit.hpp"
#include "workbench/model/fit/parameter_search.hpp"
#include "workbench/model/fit/random_walk.hpp"
#include "workbench/model/judge/intervals.hpp"

namespace workbench {
namespace {

// Where the error is smooth the walk spreads as far as the linearised intervals do.
TEST(RandomWalk, AgreesWithTheLinearIntervalsWhereTheErrorIsSmooth) {
  test::SetpointLoop loop;
  loop.delay = 6;
  const Recording recording = simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Fit fit = fitter.start({&effects::process_dead_time()});
  const FitIntervals linear = intervals_of(fitter, fit);
  const Situation here = fitter.situation(fit);
  FreeRun run(here, fitter.blocks(), fit.effects);
  const double samples = static_cast<double>(fitter.blocks().estimation_samples());
  const std::vector<double> scale(fit.p.size(), 0.01);
  const Walk walk = walk_around(run, fit.p, scale, fit.error / samples, 4000);
  ASSERT_EQ(walk.p.size(), 3000u);
  ASSERT_EQ(walk.coefficients.size(), 3000u);
  for (std::size_t i = 1; i < fit.p.size(); ++i) {
    if (!FreeRun::is_searched(fit.slots, fit.p, i)) continue;
    const SearchedParameter& parameter = fit.slots[i].parameter;
    double sum = 0;
    double square = 0;
    for (const std::vector<double>& p : walk.p) {
      sum += p[i];
      square += p[i] * p[i];
    }
    const double mean = sum / 3000;
    const double deviation = std::sqrt(square / 3000 - mean * mean);
    const double width = to_search(parameter, linear.searched[i].high) -
                         to_search(parameter, linear.searched[i].low);
    EXPECT_NEAR(3.92 * deviation / width, 1, 0.35) << parameter.name;
  }
}

TEST(RandomWalk, StaysWithinTheBoundsAndIsTheSameAgain) {
  test::SetpointLoop loop;
  loop.valve = test::backlash(3);
  const Recording recording = simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Fit fit = fitter.start({&effects::valve_backlash()});
  const Situation here = fitter.situation(fit);
  FreeRun run(here, fitter.blocks(), fit.effects);
  const std::vector<double> scale(fit.p.size(), 0.1);
  const Walk a = walk_around(run, fit.p, scale, 1e3, 400);
  const Walk b = walk_around(run, fit.p, scale, 1e3, 400);
  EXPECT_EQ(a.p, b.p);
  for (const std::vector<double>& p : a.p) {
    for (std::size_t i = 1; i < p.size(); ++i) {
      const SearchedParameter& parameter = fit.slots[i].parameter;
      const double value = from_search(parameter, p[i]);
      EXPECT_GE(value, parameter.low * (1 - 1e-9) - 1e-9);
      EXPECT_LE(value, parameter.high * (1 + 1e-9) + 1e-9);
    }
  }
}

TEST(Intervals, OfABacklashHoldTheTruth) {
  int covered = 0;
  for (std::uint64_t seed = 1000; seed < 1010; ++seed) {
    test::SetpointLoop loop;
    loop.seed = seed;
    loop.valve = test::backlash(3);
    const Recording recording = simulated(loop);
    const Fitter fitter(recording, Column::y);
    const Fit fit = fitter.start({&effects::valve_backlash()});
    const FitIntervals intervals = thorough_intervals_of(fitter, fit);
    for (std::size_t i = 0; i < fit.p.size(); ++i) {
      if (fit.slots[i].parameter.name != "deadband") continue;
      covered += intervals.searched[i].low <= 3 && 3 <= intervals.searched[i].high;
    }
  }
  EXPECT_GE(covered, 9);
}

}  // namespace
}  // namespace workbench
