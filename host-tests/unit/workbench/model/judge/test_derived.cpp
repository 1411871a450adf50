// The stick band of a fitted valve, from deadband and slip jump, with its own interval.
#include <gtest/gtest.h>

#include <cmath>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/judge/fitted_model.hpp"

namespace workbench {
namespace {

constexpr double kBand = 3;  // deadband 1 and slip jump 2, units of u

// A stem that stays until u is kBand ahead, or behind, then stops half a deadband short.
std::function<double(double)> sticking(double deadband, double jump) {
  return [=, stem = std::nan("")](double u) mutable {
    if (std::isnan(stem)) stem = u;
    const double pull = u - stem;
    if (std::abs(pull) > deadband / 2 + jump) {
      stem = u - std::copysign(deadband / 2, pull);
    }
    return stem;
  };
}

Recording recording() {
  test::SetpointLoop loop;
  loop.noise_std = 0.1;
  loop.valve = sticking(1, 2);
  return test::simulated(loop);
}

double width(const Interval& interval) {
  return interval.high - interval.low;
}

TEST(Derived, AddsUpItsPartsAndCoversTheStickBand) {
  const Recording loop = recording();
  const Fitter fitter(loop, Column::y);
  const Fit fit = fitter.start({&effects::valve_stiction()});
  for (const bool thorough : {false, true}) {
    const FitIntervals intervals =
        thorough ? thorough_intervals_of(fitter, fit) : intervals_of(fitter, fit);
    ASSERT_EQ(intervals.derived.size(), 2u);
    for (const DerivedValue& band : intervals.derived) {
      EXPECT_DOUBLE_EQ(band.value, fit.p[band.slots[0]] + fit.p[band.slots[1]]);
      const double near = 0.01 * width(band.interval);
      EXPECT_LE(band.interval.low, kBand + near) << band.parameter->name << thorough;
      EXPECT_GE(band.interval.high, kBand - near) << band.parameter->name << thorough;
      EXPECT_GE(band.interval.low, 0);
      // What deadband gains, slip jump loses.
      EXPECT_LT(width(band.interval), width(intervals.searched[band.slots[0]]) +
                                          width(intervals.searched[band.slots[1]]));
    }
  }
}

TEST(Derived, StandsAmongTheParametersAndIsMarked) {
  const Recording loop = recording();
  const Fitter fitter(loop, Column::y);
  const Model model = model_of(fitter, fitter.start({&effects::valve_stiction()}));
  int derived = 0;
  for (const Parameter& parameter : model.effects.at(0).parameters) {
    const bool band = parameter.name.rfind("stick_band_", 0) == 0;
    EXPECT_EQ(parameter.derived, band) << parameter.name;
    derived += parameter.derived;
  }
  EXPECT_EQ(derived, 2);
}

TEST(Derived, IsNoneOfAnEffectThatHasNoParts) {
  const Recording loop = test::simulated({});
  const Fitter fitter(loop, Column::y);
  EXPECT_TRUE(derived_of(fitter.start({})).empty());
}

}  // namespace
}  // namespace workbench
