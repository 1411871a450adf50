// An effect added to a model with a stem.
#include <gtest/gtest.h>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/search/in_step.hpp"

namespace workbench {
namespace {

TEST(InStep, AStemThatSlippedElsewhereIsPutBack) {
  test::SetpointLoop loop;
  loop.valve = test::slipping();
  const Recording recording = test::simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Effect& stem = effects::valve_stiction();
  const Effect& ramp = effects::disturbance_ramp();
  const Fit before = fitter.start({&stem});
  const Fit added = fitter.extend(before, ramp, Effort::kThorough).value();
  Fit elsewhere = added;
  for (std::size_t i = 0; i < elsewhere.p.size(); ++i) {
    if (elsewhere.slots[i].effect == &stem) elsewhere.p[i] *= 1.3;
  }
  for (double& e : elsewhere.residual) e *= 2;
  ASSERT_TRUE(loses_step(fitter, before, elsewhere));
  const Fit now = in_step(fitter, before, elsewhere, ramp);
  EXPECT_LE(now.error, before.error);
  EXPECT_LE(fitter.rmse_on(now, false), 1.02 * fitter.rmse_on(before, false));
  EXPECT_EQ(now.searched_of(stem)[0], before.searched_of(stem)[0]) << "its deadband";
  EXPECT_EQ(now.effects.back(), &ramp);
}

TEST(InStep, WhatHelpsStaysAsItIs) {
  test::SetpointLoop loop;
  loop.load = [](std::size_t k) { return k < 500 ? 0.0 : 6.0; };
  const Recording recording = test::simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Effect& step = effects::disturbance_step();
  const Fit before = fitter.start({});
  const Fit added = fitter.extend(before, step, Effort::kThorough).value();
  EXPECT_FALSE(loses_step(fitter, before, added));
  EXPECT_EQ(in_step(fitter, before, added, step).p, added.p);
}

}  // namespace
}  // namespace workbench
