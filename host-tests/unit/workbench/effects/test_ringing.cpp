// A ringing pair of storages against its closed solution.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "workbench/effects/ringing.hpp"

namespace workbench {
namespace {

// Step response of a pair: 1 − e^{−dwt} (cos(vt) + dw/v sin(vt)).
double pair_step(double t, double period, double damping) {
  const double w = 2 * std::numbers::pi / period;
  const double v = w * std::sqrt(1 - damping * damping);
  return 1 - std::exp(-damping * w * t) *
                 (std::cos(v * t) + damping * w / v * std::sin(v * t));
}

std::vector<double> step_at_one(std::size_t n) {
  std::vector<double> in(n, 1.0);
  in[0] = 0;
  return in;
}

TEST(Ringing, APairAloneRingsAsItsPolesSay) {
  ProcessShape shape;
  shape.ring_period_s = 12;
  shape.ring_damping = 0.2;
  const auto in = step_at_one(60);
  std::vector<double> out(in.size());
  ring_behind_lags(shape, 1, in, out);
  EXPECT_EQ(out[1], 0);
  for (std::size_t k = 2; k < out.size(); ++k) {
    EXPECT_NEAR(out[k], pair_step(static_cast<double>(k) - 1, 12, 0.2), 1e-9);
  }
}

TEST(Ringing, DampedByOneItDoesNotOvershootEvenBehindALag) {
  ProcessShape shape;
  shape.first_lag_s = 5;
  shape.ring_period_s = 12;
  const auto in = step_at_one(200);
  std::vector<double> out(in.size());
  ring_behind_lags(shape, 1, in, out);
  for (std::size_t k = 1; k < out.size(); ++k) EXPECT_GE(out[k], out[k - 1]);
  EXPECT_NEAR(out.back(), 1, 1e-6);
}

TEST(Ringing, BehindAnIntegratorItsMeanRunsOn) {
  ProcessShape shape;
  shape.integrating = true;
  shape.ring_period_s = 10;
  shape.ring_damping = 0.3;
  const std::vector<double> in(300, 1.0);
  std::vector<double> out(in.size());
  ring_behind_lags(shape, 1, in, out);
  const double delay = 2 * 0.3 * 10 / (2 * std::numbers::pi);
  EXPECT_NEAR(out[299], 299 - delay, 1e-6);
}

TEST(Ringing, ASlowSignalPassesThePairAlone) {
  ProcessShape shape;
  shape.ring_period_s = 6;
  shape.ring_damping = 0.5;
  std::vector<double> signal(500);
  for (std::size_t k = 0; k < signal.size(); ++k) {
    signal[k] = std::sin(0.01 * static_cast<double>(k));
  }
  const std::vector<double> before = signal;
  ring(shape, 1, signal);
  for (std::size_t k = 50; k < signal.size(); ++k) {
    EXPECT_NEAR(signal[k], before[k], 0.02);
  }
}

TEST(Ringing, RingsOffWithItsPeriod) {
  ProcessShape shape;
  shape.ring_period_s = 20;
  shape.ring_damping = 0.1;
  std::vector<double> even(200);
  std::vector<double> odd(200);
  ring_off(shape, 1, even, odd);
  EXPECT_EQ(even[0], 1);
  EXPECT_EQ(odd[0], 0);
  EXPECT_LT(std::abs(even[199]), 0.01);
  EXPECT_LT(even[10], -0.6);
}

}  // namespace
}  // namespace workbench
