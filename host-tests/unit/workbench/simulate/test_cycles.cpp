#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "workbench/recording/statistics.hpp"
#include "workbench/simulate/cycles.hpp"
#include "workbench/simulate/random.hpp"

namespace workbench {
namespace {

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

}  // namespace
}  // namespace workbench
