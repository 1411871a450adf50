// Which of two lags in series is that of the process.
#include <gtest/gtest.h>

#include <utility>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/fit/fit.hpp"
#include "workbench/model/fit/lags_in_series.hpp"

namespace workbench {
namespace {

Recording behind_a_sensor(double lag_samples) {
  test::SetpointLoop loop;
  loop.noise_std = 0.05;
  loop.sensor = [reading = 50.0, lag_samples](double y) mutable {
    return reading += (y - reading) / lag_samples;
  };
  return simulated(loop);
}

TEST(LagsInSeries, TheSlowerOneIsThatOfTheProcess) {
  const Recording recording = behind_a_sensor(6);
  const Fitter fitter(recording, Column::y);
  const Effect& sensor = effects::sensor_lag();
  const auto fit = fitter.extend(fitter.start({}), sensor, Effort::kThorough);
  ASSERT_TRUE(fit);
  const double first = *fit->process_value("first_lag");
  const double second = fit->searched_of(sensor)[0];
  EXPECT_GT(first, 2 * second);

  const Situation here = fitter.situation(*fit);
  FreeRun run(here, fitter.blocks(), {&sensor});
  std::vector<double> swapped = fit->p;
  const std::size_t slot = run.first_slot(sensor);
  std::swap(swapped[1], swapped[slot]);
  const std::vector<double> back = slowest_first(run, swapped);
  EXPECT_NEAR(back[1], first, 0.1 * first);
  EXPECT_NEAR(back[slot], second, 0.2 * second);
}

TEST(LagsInSeries, WhatIsInOrderStays) {
  const Recording recording = behind_a_sensor(6);
  const Fitter fitter(recording, Column::y);
  const auto fit =
      fitter.extend(fitter.start({}), effects::sensor_lag(), Effort::kThorough);
  ASSERT_TRUE(fit);
  const Situation here = fitter.situation(*fit);
  FreeRun run(here, fitter.blocks(), {&effects::sensor_lag()});
  EXPECT_EQ(slowest_first(run, fit->p), fit->p);
}

}  // namespace
}  // namespace workbench
