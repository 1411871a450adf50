// Effects that could stand for one another.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/judge/rivals.hpp"

namespace workbench {
namespace {

using test::SetpointLoop;
using test::simulated;

Recording loose_loop() {
  SetpointLoop loop;
  loop.valve = test::backlash(3);
  return simulated(loop);
}

TEST(Rivals, ASecondLagIsOneOfThree) {
  SetpointLoop loop;
  double z = 50;
  loop.sensor = [&z](double y) { return z += (y - z) / 8; };
  const Recording recording = simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Fit fit = fitter.start({&effects::process_second_lag()});
  const auto rivals =
      rivals_of(fitter, fit, effects::process_second_lag(), standard_catalogue());
  for (const char* other : {"valve.positioner_lag", "sensor.lag"}) {
    EXPECT_NE(std::find(rivals.begin(), rivals.end(), other), rivals.end()) << other;
  }
}

TEST(Rivals, ShowInOtherViewsTooAndArePossibleThemselves) {
  SetpointLoop loop;
  loop.delay = 2;
  loop.noise_std = 3;
  const Recording recording = simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Effect& dead_time = effects::process_dead_time();
  const Fit fit = fitter.start({&dead_time});
  const auto rivals = rivals_of(fitter, fit, dead_time, standard_catalogue());
  EXPECT_FALSE(rivals.empty());
  const Fit rest = fitter.without(fit, dead_time);
  for (const std::string& code : rivals) {
    const Effect& other = *standard_catalogue().find(code);
    EXPECT_NE(&other, &dead_time);
    const auto next = replaced(fitter, fit, rest, other);
    ASSERT_TRUE(next) << code;
    EXPECT_LT(fitter.rmse_on(*next, false), 1.02 * fitter.rmse_on(fit, false)) << code;
  }
}

TEST(Rivals, NothingElseMakesTheLevelsOfARecord) {
  Recording recording = loose_loop();
  for (double& y : recording.y) y = std::round(y);
  const Fitter fitter(recording, Column::y);
  const Effect& levels = effects::sensor_quantisation();
  const Fit fit = fitter.start({&levels});
  for (const std::string& code : rivals_of(fitter, fit, levels, standard_catalogue())) {
    EXPECT_FALSE(code.starts_with("valve") || code.starts_with("process")) << code;
  }
}

TEST(Rivals, NothingIsSimplerThanBacklashNorThanAStemThatSlips) {
  const Recording gap = loose_loop();
  const Fitter of_gap(gap, Column::y);
  const Fit loosely = of_gap.start({&effects::valve_backlash()});
  EXPECT_FALSE(
      simplified(of_gap, loosely, effects::valve_backlash(), standard_catalogue()));
  SetpointLoop stuck;
  double x = 50;
  stuck.valve = [&x](double u) { return x = u - x > 4 || x - u > 4 ? u : x; };
  const Recording slips = simulated(stuck);
  const Fitter of_slips(slips, Column::y);
  const Fit slipping = of_slips.start({&effects::valve_stiction()});
  EXPECT_FALSE(
      simplified(of_slips, slipping, effects::valve_stiction(), standard_catalogue()));
}

std::optional<Fit> with_stiction(const Fitter& fitter) {
  return fitter.extend(fitter.start({}), effects::valve_stiction(), Effort::kThorough);
}

TEST(Rivals, FewWideMovesDoNotShowWhetherAStemSlips) {
  constexpr double kLevels[] = {50, 58, 45, 56, 44, 57, 48};
  const Recording recording = test::stepped(kLevels, test::backlash(3));
  const Fitter fitter(recording, Column::y);
  const Fit play = fitter.start({&effects::valve_backlash()});
  EXPECT_TRUE(leaves_slip_open(fitter, play, *with_stiction(fitter)));
}

TEST(Rivals, MovesOfAllSizesShowThatAStemDoesNotSlip) {
  const Recording recording = loose_loop();
  const Fitter fitter(recording, Column::y);
  const Fit play = fitter.start({&effects::valve_backlash()});
  EXPECT_FALSE(leaves_slip_open(fitter, play, *with_stiction(fitter)));
}

}  // namespace
}  // namespace workbench
