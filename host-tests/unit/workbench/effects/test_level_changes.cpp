// When a level changed, for good or for a while, at rest and where the controller
// answered.
#include <gtest/gtest.h>

#include <random>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/level_changes.hpp"
#include "workbench/model/fit/fit.hpp"

namespace workbench {
namespace {

TEST(LevelChanges, DatesTheChange) {
  std::vector<double> residual(500, 0.0);
  for (std::size_t k = 300; k < 500; ++k) residual[k] = 1;
  const std::vector<unsigned char> all(500, 1);
  Situation s;
  s.residual = residual;
  s.estimation = all;
  const auto changes = level_changes(s).for_good;
  ASSERT_FALSE(changes.empty());
  EXPECT_EQ(changes[0], 300u);
}

TEST(LevelChanges, KnowsNoneWhereNothingIsLeft) {
  const std::vector<double> residual(500, 0.0);
  const std::vector<unsigned char> all(500, 1);
  Situation s;
  s.residual = residual;
  s.estimation = all;
  EXPECT_TRUE(level_changes(s).for_good.empty());
}

// The controller takes a load off y, and the model without the load has bent its gain.
TEST(LevelChanges, DatesALoadThatTheControllerAnswers) {
  test::SetpointLoop loop;
  loop.load = [](std::size_t k) { return k < 730 ? 0.0 : 60.0; };
  const Recording recording = test::simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Fit bent = fitter.start({});
  const auto changes = level_changes(fitter.situation(bent)).for_good;
  ASSERT_FALSE(changes.empty());
  EXPECT_NEAR(static_cast<double>(changes[0]), 730, 20);
}

// White noise around a level that another one follows from 300 on, until `end`.
std::vector<PassingLevel> passing(std::size_t end, double height) {
  std::mt19937_64 random(1000);
  std::normal_distribution<double> noise;
  std::vector<double> residual(1000);
  for (std::size_t k = 0; k < residual.size(); ++k) {
    residual[k] = noise(random) + (k >= 300 && k < end ? height : 0);
  }
  const std::vector<unsigned char> all(residual.size(), 1);
  Situation s;
  s.residual = residual;
  s.estimation = all;
  return level_changes(s).passing;
}

TEST(LevelChanges, DatesBothEndsOfWhatPasses) {
  const auto levels = passing(420, 4);
  ASSERT_FALSE(levels.empty());
  EXPECT_NEAR(static_cast<double>(levels[0].first), 300, 2);
  EXPECT_NEAR(static_cast<double>(levels[0].last), 420, 2);
}

TEST(LevelChanges, WhatStaysDoesNotPass) {
  EXPECT_TRUE(passing(1000, 4).empty());
  EXPECT_TRUE(passing(300, 0).empty());
}

}  // namespace
}  // namespace workbench
