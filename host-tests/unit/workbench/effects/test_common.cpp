// What several effects share: friction and the curve.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "workbench/effects/common.hpp"

namespace workbench::effects {
namespace {

std::vector<double> moved(const StemFriction& friction, std::vector<double> u,
                          std::size_t* at_rest = nullptr) {
  ValveSignal signal{1, u, 0};
  move_with_friction(friction, signal);
  if (at_rest != nullptr) *at_rest = signal.at_rest;
  return u;
}

TEST(StemFriction, NoneIsAStemThatFollows) {
  const std::vector<double> u = {0, 3, 1, -2, 5};
  EXPECT_EQ(moved({}, u), u);
}

TEST(StemFriction, BacklashLosesItsWidthAtEachReversal) {
  const std::vector<double> u = {0, 1, 2, 3, 2, 1, 0, 1, 2};
  EXPECT_EQ(moved({2, 0, 0, 0}, u), (std::vector<double>{0, 0, 1, 2, 2, 2, 1, 1, 1}));
}

TEST(StemFriction, ASlipTakesTheStemToTheSignalAtOnceAndItHoldsAgain) {
  std::size_t at_rest = 0;
  const std::vector<double> u = {0, 1, 2, 3, 4, 5, 6, 7};
  EXPECT_EQ(moved({0, 2.5, 2.5, 0}, u, &at_rest),
            (std::vector<double>{0, 0, 0, 3, 3, 3, 6, 6}));
  EXPECT_EQ(at_rest, 3u);
}

TEST(StemFriction, ASlowSlipApproachesExponentially) {
  const std::vector<double> u = {0, 4, 4, 4};
  const auto x = moved({0, 2, 2, 3}, u);
  const double left = std::exp(-1.0 / 3);
  EXPECT_NEAR(x[1], 4 - 4 * 3 * (1 - left), 1e-12);
  EXPECT_NEAR(x[2], 4 - 4 * left * 3 * (1 - left), 1e-12);
}

TEST(StemFriction, StrokesStickApart) {
  const std::vector<double> u = {0, 2, 4, 2, 0, -2, -4};
  EXPECT_EQ(moved({0, 0, 5, 0}, u), (std::vector<double>{0, 2, 4, 4, 4, -2, -4 + 2}));
}

TEST(LagStarts, ReachFromBelowASampleToBeyondTheFirstLag) {
  const std::vector<double> u(1000, 0.0);
  Situation s = situation_of(u, u, 1);
  s.first_lag_s = 30;
  const auto starts = lag_starts(s);
  EXPECT_LE(starts.front()[0], 0.5);
  EXPECT_GE(starts.back()[0], 60);
}

}  // namespace
}  // namespace workbench::effects
