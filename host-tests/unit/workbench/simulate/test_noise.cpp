#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "workbench/simulate/cycles.hpp"
#include "workbench/simulate/noise.hpp"
#include "workbench/simulate/random.hpp"
#include "workbench/simulate/setpoint_moves.hpp"

namespace workbench {
namespace {

TEST(SimulateRandom, RepeatsForOneLabelAndSeedOnly) {
  Random a("label", 7);
  Random b("label", 7);
  Random other_seed("label", 8);
  Random other_label("lebal", 7);
  const double first = a.uniform();
  EXPECT_EQ(first, b.uniform());
  EXPECT_NE(first, other_seed.uniform());
  EXPECT_NE(first, other_label.uniform());
}

TEST(SimulateRandom, IsTheSameStreamEverywhere) {
  // std::mt19937_64 and 53 bits of it: no platform may differ.
  Random random("golden", 1);
  EXPECT_EQ(random.uniform(), 0x1.c6f66a90fd585p-1);
  EXPECT_EQ(random.uniform(), 0x1.9532edd768268p-2);
}

TEST(SimulateRandom, MomentsAndRanges) {
  Random random("moments", 3);
  double sum = 0;
  double squares = 0;
  double fourth = 0;
  constexpr int kDraws = 200000;
  for (int i = 0; i < kDraws; ++i) {
    const double z = random.normal();
    sum += z;
    squares += z * z;
    fourth += z * z * z * z;
  }
  // Five standard deviations of each estimate.
  EXPECT_NEAR(sum / kDraws, 0, 5 / std::sqrt(kDraws));
  EXPECT_NEAR(squares / kDraws, 1, 5 * std::sqrt(2.0 / kDraws));
  EXPECT_NEAR(fourth / kDraws, 3, 5 * std::sqrt(96.0 / kDraws));

  bool seen[3] = {};
  for (int i = 0; i < 1000; ++i) {
    const int drawn = random.integer(-1, 1);
    ASSERT_GE(drawn, -1);
    ASSERT_LE(drawn, 1);
    seen[drawn + 1] = true;
    const double u = random.log_uniform(0.5, 8);
    ASSERT_GE(u, 0.5);
    ASSERT_LT(u, 8.0000001);
  }
  EXPECT_TRUE(seen[0] && seen[1] && seen[2]);
}

TEST(SimulateNoise, PaperNoiseHasVarianceOfItsFilter) {
  Random random("noise", 1);
  const auto v = first_order_noise(random, 200000, -0.5, std::sqrt(0.001));
  EXPECT_NEAR(std_of(v), std::sqrt(0.001 / 0.75), 3e-4);
  double lag = 0;
  for (std::size_t t = 1; t < v.size(); ++t) lag += v[t] * v[t - 1];
  EXPECT_NEAR(lag / static_cast<double>(v.size()) / (0.001 / 0.75), -0.5, 0.02);
}

TEST(SimulateNoise, ColouredNoiseHasTheWantedSize) {
  Random random("noise", 2);
  EXPECT_NEAR(std_of(coloured_noise(random, 200000, 0.8, 3)), 3, 0.1);
}

TEST(SimulateCycles, CountsASineWithNoise) {
  Random random("cycles", 1);
  std::vector<double> signal;
  for (int t = 0; t < 1000; ++t) {
    signal.push_back(5 + std::sin(2 * std::numbers::pi * t / 40.0) +
                     0.03 * random.normal());
  }
  const Cycles cycles = measure_cycles(signal);
  // 24 rises, the first one a period after the start.
  EXPECT_EQ(cycles.count, 23);
  EXPECT_NEAR(cycles.period, 40, 0.2);
  EXPECT_LT(cycles.spread, 0.05);
}

TEST(SimulateCycles, FindsNoneInAConstant) {
  const Cycles cycles = measure_cycles(std::vector<double>(100, 3.0));
  EXPECT_EQ(cycles.count, 0);
  EXPECT_EQ(cycles.period, 0);
}

TEST(SimulateCycles, FiguresByHand) {
  const std::vector<double> signal{1, 2, 3, 6};
  EXPECT_DOUBLE_EQ(mean_of(signal), 3);
  EXPECT_DOUBLE_EQ(std_of(signal), std::sqrt(14.0 / 4));
  EXPECT_DOUBLE_EQ(swing_of(signal), 5);
}

TEST(SimulateMoves, StayInRangeAndMove) {
  Random random("moves", 1);
  for (int i = 0; i < 50; ++i) {
    const auto signal = draw_moves(random, 1000, 50);
    ASSERT_EQ(signal.size(), 1000u);
    EXPECT_LE(std::abs(*std::ranges::max_element(signal)), 1);
    EXPECT_GE(*std::ranges::min_element(signal), -1);
    EXPECT_GT(swing_of(signal), 0.25);
  }
}

TEST(SimulateMoves, SinusoidKeepsItsPeriodWithinItsIrregularity) {
  Random random("moves", 2);
  const Cycles strict = measure_cycles(sinusoid(random, 4000, 50, 0));
  EXPECT_NEAR(strict.period, 50, 0.1);
  EXPECT_LT(strict.spread, 0.02);
  const Cycles loose = measure_cycles(sinusoid(random, 4000, 50, 0.06));
  EXPECT_NEAR(loose.period, 50, 3);
  EXPECT_GT(loose.spread, 0.02);
  EXPECT_LT(loose.spread, 0.12);
}

}  // namespace
}  // namespace workbench
