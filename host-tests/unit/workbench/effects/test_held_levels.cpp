// A sweep by hand: the levels at which u was held, and what y came to at each.
#include <gtest/gtest.h>

#include <vector>

#include "workbench/effects/held_levels.hpp"

namespace workbench {
namespace {

constexpr std::size_t kHold = 30;

// u from 0 to 100 in steps of 10, y its square behind a lag of two samples.
struct Sweep {
  Sweep() {
    double slow = 0;
    for (std::size_t k = 0; k < 11 * kHold; ++k) {
      u.push_back(10.0 * static_cast<double>(k / kHold));
      slow += 0.4 * (u[k] * u[k] / 100 - slow);
      y.push_back(slow);
    }
  }
  std::vector<double> u;
  std::vector<double> y;
};

TEST(HeldLevels, CountsTheLevelsOfASweep) {
  const Sweep sweep;
  EXPECT_EQ(levels_held(sweep.u), 10);
  EXPECT_EQ(levels_held(sweep.y), 0);  // moves most of the time
  EXPECT_EQ(levels_held({}), 0);
}

TEST(HeldLevels, TheCurveIsWhatTheOutputCameTo) {
  const Sweep sweep;
  const auto curve = SettledCurve::seen_in(situation_of(sweep.u, sweep.y, 1.0));
  ASSERT_TRUE(curve);
  EXPECT_NEAR((*curve)(40), 16, 0.1);
  EXPECT_NEAR((*curve)(45), 20.5, 0.1);  // between 16 and 25
  EXPECT_NEAR((*curve)(-5), 0, 0.1);
  EXPECT_NEAR((*curve)(120), 100, 0.2);
}

TEST(HeldLevels, WhatOnlyJudgesIsNotLookedAt) {
  const Sweep sweep;
  std::vector<unsigned char> estimation(sweep.u.size(), 1);
  for (std::size_t k = 4 * kHold; k < 5 * kHold; ++k) estimation[k] = 0;
  Situation s = situation_of(sweep.u, sweep.y, 1.0);
  s.estimation = estimation;
  const auto curve = SettledCurve::seen_in(s);
  ASSERT_TRUE(curve);
  EXPECT_NEAR((*curve)(40), 17, 0.1);  // between those of 30 and 50
}

TEST(HeldLevels, FewLevelsOrAnIntegratorHaveNoCurve) {
  const Sweep sweep;
  const std::size_t few = 5 * kHold;
  EXPECT_FALSE(SettledCurve::seen_in(
      situation_of(std::span(sweep.u).first(few), std::span(sweep.y).first(few), 1.0)));
  Situation s = situation_of(sweep.u, sweep.y, 1.0);
  s.integrating = true;
  EXPECT_FALSE(SettledCurve::seen_in(s));
}

}  // namespace
}  // namespace workbench
