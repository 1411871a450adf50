#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "workbench/simulate/closed_loop.hpp"
#include "workbench/simulate/cycles.hpp"
#include "workbench/simulate/he_valve.hpp"
#include "workbench/simulate/linear_valve.hpp"

namespace workbench {
namespace {

TEST(SimulateRunLoop, InputActsOneSampleAndTheDeadTimeLater) {
  LoopSetup setup;
  setup.process = {1, 0, 0, 3, false};
  setup.controller = {1, 1e9};
  setup.samples = 8;
  setup.setpoint = {0, 1};
  LinearValve valve;
  const Trajectory run = run_loop(setup, valve);
  // u rises at sample 1; y answers 1 + 3 samples later.
  const std::vector<double> expected{0, 0, 0, 0, 0, 1, 1, 1};
  for (std::size_t t = 0; t < 8; ++t) EXPECT_NEAR(run.y[t], expected[t], 1e-6) << t;
  EXPECT_NEAR(run.u[1], 1, 1e-6);
  EXPECT_EQ(run.u[0], 0);
}

TEST(SimulateRunLoop, IntegralActionRemovesLoadsAndBias) {
  LoopSetup setup;
  setup.process = {2, 5, 0, 1, false};
  setup.controller = {0.5, 5};
  setup.rest_u = 40;
  setup.input_bias = 3;
  setup.output_load = {7};
  setup.setpoint = {10};
  setup.warm_up = 500;
  setup.samples = 10;
  LinearValve valve;
  const Trajectory run = run_loop(setup, valve);
  for (std::size_t t = 0; t < 10; ++t) {
    EXPECT_NEAR(run.y[t], 10, 1e-9);
    EXPECT_NEAR(run.y_clean[t], 3, 1e-9);       // without the load
    EXPECT_NEAR(run.x[t], 40 + 1.5 - 3, 1e-9);  // 2 (x - 40 + 3) = 3
    EXPECT_EQ(run.u[t], run.x[t]);
  }
}

TEST(SimulateRunLoop, InputLoadReachesTheOutputButNotTheCleanOne) {
  LoopSetup setup;
  setup.process = {1, 2, 0, 0, false};
  setup.controller = {1e-12, 1};
  setup.input_load = {1};
  setup.samples = 100;
  LinearValve valve;
  const Trajectory run = run_loop(setup, valve);
  EXPECT_NEAR(run.y.back(), 1, 1e-6);
  EXPECT_NEAR(run.y_clean.back(), 0, 1e-6);
}

TEST(SimulateRunLoop, QuantisesInsideTheLoop) {
  LoopSetup setup;
  setup.process = {1, 4, 0, 0, false};
  setup.controller = {0.5, 3};
  setup.setpoint = {3.3};
  setup.y_resolution = 0.25;
  setup.u_resolution = 0.5;
  setup.samples = 200;
  LinearValve valve;
  const Trajectory run = run_loop(setup, valve);
  for (std::size_t t = 0; t < 200; ++t) {
    EXPECT_EQ(std::fmod(run.y[t], 0.25), 0);
    EXPECT_EQ(std::fmod(run.u[t], 0.5), 0);
    EXPECT_EQ(run.x[t], run.u[t]);
  }
}

TEST(SimulateRunLoop, AStickingSensorStaysFlatAndJumps) {
  LoopSetup setup;
  setup.process = {1, 5, 0, 0, false};
  setup.controller = {1e-9, 1e9};
  setup.samples = 6;
  setup.sensor = friction_from_s_j(2, 2);  // jumps to the truth beyond 2
  setup.output_load = {0, 1, 2, 2.5, 3, 0};
  LinearValve valve;
  const Trajectory run = run_loop(setup, valve);
  const std::vector<double> expected{0, 0, 0, 2.5, 2.5, 0};
  for (std::size_t t = 0; t < expected.size(); ++t) {
    EXPECT_NEAR(run.y[t], expected[t], 1e-6) << t;
  }
}

TEST(SimulateRunLoop, PositionerDelaysTheStem) {
  LoopSetup setup;
  setup.process = {0, 1, 0, 0, false};
  setup.controller = {1, 1e12};
  setup.setpoint = {1};
  setup.positioner_lag_s = 2;
  setup.samples = 5;
  LinearValve valve;
  const Trajectory run = run_loop(setup, valve);
  EXPECT_NEAR(run.x[0], 1 - std::exp(-0.5), 1e-9);
  EXPECT_NEAR(run.x[1], 1 - std::exp(-1.0), 1e-9);
}

TEST(SimulateRunLoop, StickingValveCyclesWhereALinearOneSettles) {
  LoopSetup setup;
  setup.process = {1, 2, 0, 1, false};
  setup.controller = {0.3, 3};
  setup.setpoint = {1.2};
  setup.warm_up = 1000;
  setup.samples = 1000;
  HeValve sticky({2, 2, 0, 0});
  LinearValve linear;
  const Trajectory cycling = run_loop(setup, sticky);
  EXPECT_GE(measure_cycles(cycling.y).count, 10);
  EXPECT_LT(swing_of(run_loop(setup, linear).y), 1e-9);
}

}  // namespace
}  // namespace workbench
