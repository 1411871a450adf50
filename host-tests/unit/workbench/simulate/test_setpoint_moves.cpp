#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "workbench/simulate/cycles.hpp"
#include "workbench/simulate/random.hpp"
#include "workbench/simulate/setpoint_moves.hpp"

namespace workbench {
namespace {

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
