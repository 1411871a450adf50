// The simulator of the hidden-effect benchmark against formulas.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/hidden/loop.hpp"
#include "support/hidden/random.hpp"

namespace hidden {
namespace {

/// Open loop from rest: u steps by `move` at the first sample.
LoopSetup step_setup(std::size_t samples = 60) {
  LoopSetup setup;
  setup.period_s = 0.5;
  setup.samples = samples;
  setup.rest_y = 7;
  setup.process.gain = -1.5;
  setup.process.first_lag_s = 4;
  setup.setpoint.assign(samples, 0);
  return setup;
}

Trace run_step(const LoopSetup& setup, double move) {
  const std::vector<double> u(setup.setpoint.size(), setup.rest_u + move);
  return run_loop(setup, &u);
}

double seconds(const LoopSetup& setup, std::size_t k) {
  return setup.period_s * static_cast<double>(k);
}

TEST(HiddenProcess, FirstOrderStepResponse) {
  const LoopSetup setup = step_setup();
  const Trace trace = run_step(setup, 2);
  for (std::size_t k = 0; k < trace.y.size(); ++k) {
    EXPECT_NEAR(trace.y[k], 7 - 3 * (1 - std::exp(-seconds(setup, k) / 4)), 1e-9) << k;
  }
}

TEST(HiddenProcess, TwoLagsWhereverTheSecondIs) {
  for (const bool sensor : {false, true}) {
    LoopSetup setup = step_setup();
    (sensor ? setup.process.sensor_lag_s : setup.process.second_lag_s) = 1.5;
    const Trace trace = run_step(setup, 2);
    for (std::size_t k = 0; k < trace.y.size(); ++k) {
      const double t = seconds(setup, k);
      const double rise = 1 - (4 * std::exp(-t / 4) - 1.5 * std::exp(-t / 1.5)) / 2.5;
      EXPECT_NEAR(trace.y[k], 7 - 3 * rise, 1e-8) << k;
    }
  }
}

TEST(HiddenProcess, PositionerIsALagBeforeALinearValve) {
  LoopSetup setup = step_setup();
  setup.valve.positioner_lag_s = 1.5;
  const Trace behind = run_step(setup, 2);
  setup.valve.positioner_lag_s = 0;
  setup.process.second_lag_s = 1.5;
  const Trace process = run_step(setup, 2);
  for (std::size_t k = 0; k < behind.y.size(); ++k) {
    EXPECT_NEAR(behind.y[k], process.y[k], 0.01) << k;  // one half sub-step apart
  }
}

TEST(HiddenProcess, DeadTimeNeedNotBeWholePeriods) {
  LoopSetup setup = step_setup();
  setup.process.dead_time_s = 1.2;
  const Trace trace = run_step(setup, 2);
  for (std::size_t k = 0; k < trace.y.size(); ++k) {
    const double t = std::max(0.0, seconds(setup, k) - 1.2);
    EXPECT_NEAR(trace.y[k], 7 - 3 * (1 - std::exp(-t / 4)), 1e-9) << k;
  }
}

TEST(HiddenProcess, IntegratorRamps) {
  LoopSetup setup = step_setup();
  setup.process.integrating = true;
  const Trace trace = run_step(setup, 2);
  for (std::size_t k = 0; k < trace.y.size(); ++k) {
    EXPECT_NEAR(trace.y[k], 7 - 3 * seconds(setup, k) / 4, 1e-9) << k;
  }
}

TEST(HiddenProcess, TankSettlesWhereOutflowMeetsInflow) {
  for (const double head : {6.0, -6.0}) {
    LoopSetup setup = step_setup(400);
    setup.process.head = head;
    const Trace trace = run_step(setup, 2);
    // ψ(z) = gain·v, so 1 + z/H = (1 + gain·v/(2H))².
    const double root = 1 - 3 / (2 * head);
    EXPECT_NEAR(trace.y.back(), 7 + head * (root * root - 1), 1e-6) << head;
  }
}

TEST(HiddenProcess, TellsWhenATankIsDrawnBelowItsBottom) {
  LoopSetup setup = step_setup(400);
  setup.process.head = 6;
  EXPECT_FALSE(run_step(setup, 7).ran_dry);  // 2H = 12 flows out no faster than 10.5
  EXPECT_TRUE(run_step(setup, 9).ran_dry);
}

TEST(HiddenProcess, OverflowCutsTheLevelAndLeavesAtOnce) {
  LoopSetup setup = step_setup(80);
  setup.process.gain = 1.5;
  setup.process.overflow = 2;
  std::vector<double> u(80, setup.rest_u + 2);
  std::fill(u.begin() + 40, u.end(), setup.rest_u);
  const Trace trace = run_loop(setup, &u);
  EXPECT_EQ(*std::max_element(trace.y.begin(), trace.y.end()), 9);
  EXPECT_EQ(trace.y[40], 9);
  for (std::size_t k = 40; k < 80; ++k) {
    EXPECT_NEAR(trace.y[k], 7 + 2 * std::exp(-seconds(setup, k - 40) / 4), 1e-9);
  }
  EXPECT_EQ(trace.overflows, 1);
}

TEST(HiddenProcess, SinusoidIsFilteredByTheProcess) {
  LoopSetup setup = step_setup(400);
  setup.warm_up = 100;
  setup.setpoint.assign(500, 0);
  setup.loads.sinusoid = 2;
  setup.loads.sinusoid_period_s = 20;
  const Trace trace = run_step(setup, 0);
  const std::vector<double> y = recorded(setup, trace.y);
  const double omega = 2 * std::numbers::pi / 20;
  const double amplitude = 3 / std::hypot(1, 4 * omega);
  EXPECT_NEAR(*std::max_element(y.begin(), y.end()), 7 + amplitude, 0.01 * amplitude);
  EXPECT_NEAR(*std::min_element(y.begin(), y.end()), 7 - amplitude, 0.01 * amplitude);
}

TEST(HiddenProcess, StepAndRampLoads) {
  LoopSetup setup = step_setup(400);
  setup.loads.step = 2;
  setup.loads.step_at_s = 100;
  const Trace step = run_step(setup, 0);
  EXPECT_EQ(step.y[200], 7);
  EXPECT_NEAR(step.y[208], 7 - 3 * (1 - std::exp(-1.0)), 1e-9);
  setup.loads = {};
  setup.loads.ramp = 2;
  const Trace ramp = run_step(setup, 0);
  // A ramp through a lag follows one lag behind.
  EXPECT_NEAR(ramp.y.back(), 7 - 3 * (seconds(setup, 399) - 4) / 200, 1e-4);
}

TEST(HiddenProcess, GainDriftsAboutItsMiddle) {
  LoopSetup setup = step_setup(2000);
  setup.process.gain_drift = 0.8;
  const Trace trace = run_step(setup, 2);
  EXPECT_NEAR(trace.y[100], 7 - 3 * (1 + 0.8 * ((50.0 - 4) / 1000 - 0.5)), 1e-3);
  EXPECT_NEAR(trace.y.back(), 7 - 3 * 1.4, 0.02);
}

/// Advances a valve along a triangle between −10 and 10 about `rest`, in fine steps.
struct Stroke {
  std::vector<double> u;
  std::vector<double> stem;
};
Stroke run_triangle(const ValvePhysics& physics, double rest, double speed, double dt) {
  HiddenValve valve(physics, rest);
  Stroke stroke;
  double u = rest;
  double direction = 1;
  for (int i = 0; i < static_cast<int>(100 / (speed * dt)); ++i) {
    u += direction * speed * dt;
    direction = u > rest + 10 ? -1 : u < rest - 10 ? 1 : direction;
    valve.advance(u, dt);
    stroke.u.push_back(u);
    stroke.stem.push_back(valve.stem());
  }
  return stroke;
}

TEST(HiddenValve, StickBandAndSlipJumpInTheStemPlane) {
  ValvePhysics physics;
  physics.static_ascending = 3;
  physics.kinetic_ascending = 1;
  physics.static_descending = 2.5;
  physics.kinetic_descending = 0.5;
  physics.slide_s = 0.01;
  const Stroke stroke = run_triangle(physics, 50, 0.1, 0.002);
  // From the turn at the bottom: nothing for a stick band, then the jump.
  const auto bottom = std::min_element(stroke.u.begin(), stroke.u.end());
  std::size_t k = static_cast<std::size_t>(bottom - stroke.u.begin());
  const double low = stroke.stem[k];
  const double turn = stroke.u[k];
  EXPECT_NEAR(low, turn + 0.5, 2.1);  // it may have stopped on the way down
  while (stroke.stem[k] == low) ++k;
  EXPECT_NEAR(stroke.u[k] - low, 3, 1e-3);
  k += 100;
  EXPECT_NEAR(stroke.u[k] - stroke.stem[k], 1, 0.1);
}

TEST(HiddenValve, RestedStemNeedsTheWholeStickBand) {
  ValvePhysics physics;
  physics.static_ascending = 3;
  physics.kinetic_ascending = 1;
  physics.static_descending = 2.5;
  physics.kinetic_descending = 0.5;
  physics.slide_s = 0.01;
  HiddenValve valve(physics, 50);
  for (int i = 0; i < 100; ++i) valve.advance(45, 0.01);
  EXPECT_NEAR(valve.stem(), 45.5, 0.05);  // one kinetic band behind
  const double rest = valve.stem();
  // Static ascending + kinetic descending = 3.5 above the turn.
  for (int i = 0; i < 100; ++i) valve.advance(48.45, 0.01);
  EXPECT_EQ(valve.stem(), rest);
  for (int i = 0; i < 100; ++i) valve.advance(48.6, 0.01);
  EXPECT_NEAR(valve.stem(), 47.6, 0.05);
  EXPECT_EQ(valve.events().turns, 2);
}

TEST(HiddenValve, KeepsSlidingUnderKineticFrictionUntilItTurns) {
  for (const bool keeps_sliding : {false, true}) {
    ValvePhysics physics;
    physics.static_ascending = physics.static_descending = 3;
    physics.kinetic_ascending = physics.kinetic_descending = 1;
    physics.slide_s = 0.01;
    physics.keeps_sliding = keeps_sliding;
    HiddenValve valve(physics, 50);
    const auto hold = [&](double u) {
      for (int i = 0; i < 100; ++i) valve.advance(u, 0.01);
      return valve.stem();
    };
    EXPECT_NEAR(hold(54), 53, 0.01);
    EXPECT_NEAR(hold(55.5), keeps_sliding ? 54.5 : 53, 0.01);
    EXPECT_NEAR(hold(56.1), 55.1, 0.01);
    EXPECT_NEAR(hold(52.2), 55.1, 0.01);  // within the stick band
    EXPECT_NEAR(hold(52), 53, 0.01);
  }
}

TEST(HiddenValve, BacklashIsHalfTheGapBehind) {
  ValvePhysics physics;
  physics.backlash = 3;
  const Stroke stroke = run_triangle(physics, 50, 0.1, 0.01);
  const auto [low, high] = std::minmax_element(stroke.stem.begin(), stroke.stem.end());
  EXPECT_NEAR(*high, 58.5, 0.01);
  EXPECT_NEAR(*low, 41.5, 0.01);
}

TEST(HiddenValve, TravelLimitsAndTheirHits) {
  ValvePhysics physics;
  physics.travel_low = 46;
  physics.travel_high = 55;
  HiddenValve valve(physics, 50);
  for (const double u : {60.0, 61.0, 54.0, 60.0, 40.0}) valve.advance(u, 1);
  EXPECT_EQ(valve.stem(), 46);
  EXPECT_EQ(valve.events().limit_hits, 3);
}

TEST(HiddenValve, RateLimitsOfBothStrokes) {
  ValvePhysics physics;
  physics.opening_rate = 2;
  physics.closing_rate = 4;
  HiddenValve valve(physics, 50);
  for (int i = 0; i < 10; ++i) valve.advance(60, 0.1);
  EXPECT_NEAR(valve.stem(), 52, 1e-12);
  EXPECT_TRUE(valve.held_back());
  for (int i = 0; i < 10; ++i) valve.advance(40, 0.1);
  EXPECT_NEAR(valve.stem(), 48, 1e-12);
  valve.advance(48, 0.1);
  EXPECT_FALSE(valve.held_back());
}

TEST(HiddenValve, EqualPercentageHasThatRangeability) {
  ValvePhysics physics;
  physics.characteristic = std::log(50) / 100;
  HiddenValve valve(physics, 0);
  const double low = valve.advance(0.01, 1) - valve.advance(0, 1);
  const double high = valve.advance(100.01, 1) - valve.advance(100, 1);
  EXPECT_NEAR(high / low, 50, 1e-6);
}

TEST(HiddenLoop, PiStepByHand) {
  LoopSetup setup = step_setup(3);
  setup.process.gain = 0;
  setup.controller.gain = 2;
  setup.controller.reset_s = 5;
  setup.setpoint = {1, 1, 1};
  const Trace trace = run_loop(setup);
  EXPECT_NEAR(trace.u[0], 50 + 2 + 0.2, 1e-12);
  EXPECT_NEAR(trace.u[1], 50 + 2 + 0.4, 1e-12);
  EXPECT_NEAR(trace.u[2], 50 + 2 + 0.6, 1e-12);
}

TEST(HiddenLoop, PiSettlesOnTheSetpointAndLeavesItsLimitAtOnce) {
  LoopSetup setup = step_setup(400);
  setup.controller.gain = -2;
  setup.controller.reset_s = 4;
  setup.setpoint.assign(400, -3);
  const Trace trace = run_loop(setup);
  EXPECT_NEAR(trace.y.back(), 4, 1e-6);
  EXPECT_NEAR(trace.u.back(), 52, 1e-6);

  setup.process.gain = 0;
  setup.setpoint.assign(400, -200);
  setup.setpoint.back() = 0.01;
  const Trace wound = run_loop(setup);
  EXPECT_EQ(wound.u[398], 100);
  EXPECT_LT(wound.u[399], 60);
}

TEST(HiddenLoop, RelayAndFloatingControllerCycle) {
  for (const ControllerKind kind : {ControllerKind::kOnOff, ControllerKind::kFloating}) {
    LoopSetup setup = step_setup(600);
    setup.controller.kind = kind;
    setup.controller.gain = -1;
    setup.controller.hysteresis = 1;
    setup.controller.swing = 5;
    setup.controller.ramp_rate = 2;
    const Trace trace = run_loop(setup);
    int above = 0;
    for (std::size_t k = 1; k < 600; ++k) {
      above += trace.y[k] > 7.5 && trace.y[k - 1] <= 7.5 ? 1 : 0;
    }
    EXPECT_GE(above, 10);
  }
}

TEST(HiddenLoop, ControllerSeesTheNoiseAndTheResolution) {
  LoopSetup setup = step_setup(50);
  setup.process.gain = 0;
  setup.controller.gain = 1;
  setup.controller.reset_s = 1e12;
  setup.noise_std = 2;
  setup.quantum = 0.5;
  Random random("noise", 1);
  for (int k = 0; k < 50; ++k) setup.noise.push_back(random.normal());
  const Trace trace = run_loop(setup);
  for (std::size_t k = 0; k < 50; ++k) {
    EXPECT_EQ(std::fmod(trace.y[k], 0.5), 0);
    EXPECT_NEAR(trace.y[k], 7 + 2 * setup.noise[k], 0.25 + 1e-12);
    EXPECT_NEAR(trace.u[k], 50 + 7 - trace.y[k], 1e-6);
    EXPECT_EQ(trace.sensed[k], 7);
  }
}

TEST(HiddenLoop, ConvergesWithTheSubSteps) {
  // Everything at once, in open loop under a rough u.
  LoopSetup setup = step_setup(300);
  setup.valve = {0.8, 3, 2.5, 2, 1.6, 0.8, 0.5, false, 0.2, 1, 42, 57, 0.03};
  setup.process = {1.5, 4, 1.5, 1.2, false, 30, 0.5, 9, 0.7};
  setup.loads = {1, 20, 0.3, 1, 70, 2};
  Random random("u", 1);
  std::vector<double> u;
  while (u.size() < 300) u.insert(u.end(), 10, 50 + random.uniform(-10, 10));
  const auto run = [&](int sub_steps) {
    setup.sub_steps = sub_steps;
    return run_loop(setup, &u).y;
  };
  const std::vector<double> fine = run(800);
  const auto error = [&](int sub_steps) {
    const std::vector<double> y = run(sub_steps);
    double most = 0;
    for (std::size_t k = 0; k < y.size(); ++k)
      most = std::max(most, std::abs(y[k] - fine[k]));
    return most;
  };
  EXPECT_LT(error(20), 0.15);  // of a swing of about 20
  EXPECT_LT(error(80), 0.5 * error(20));
}

TEST(HiddenRandom, MomentsAndStreams) {
  Random random("a", 1);
  double sum = 0;
  double squares = 0;
  constexpr int kDraws = 100000;
  for (int i = 0; i < kDraws; ++i) {
    const double draw = random.normal();
    sum += draw;
    squares += draw * draw;
  }
  EXPECT_NEAR(sum / kDraws, 0, 0.02);
  EXPECT_NEAR(squares / kDraws, 1, 0.02);
  EXPECT_NE(Random("a", 1).uniform(), Random("b", 1).uniform());
  EXPECT_NE(Random("a", 1).uniform(), Random("a", 2).uniform());
  EXPECT_EQ(Random("a", 1).uniform(), Random("a", 1).uniform());
}

}  // namespace
}  // namespace hidden
