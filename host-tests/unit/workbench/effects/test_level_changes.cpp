// When a level changed, at rest and where the controller answered.
#include <gtest/gtest.h>

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
  const auto changes = level_changes(s);
  ASSERT_FALSE(changes.empty());
  EXPECT_EQ(changes[0], 300u);
}

TEST(LevelChanges, KnowsNoneWhereNothingIsLeft) {
  const std::vector<double> residual(500, 0.0);
  const std::vector<unsigned char> all(500, 1);
  Situation s;
  s.residual = residual;
  s.estimation = all;
  EXPECT_TRUE(level_changes(s).empty());
}

// The controller takes a load off y, and the model without the load has bent its gain.
TEST(LevelChanges, DatesALoadThatTheControllerAnswers) {
  test::SetpointLoop loop;
  loop.load = [](std::size_t k) { return k < 730 ? 0.0 : 60.0; };
  const Recording recording = test::simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Fit bent = fitter.start({});
  const auto changes = level_changes(fitter.situation(bent));
  ASSERT_FALSE(changes.empty());
  EXPECT_NEAR(static_cast<double>(changes[0]), 730, 20);
}

}  // namespace
}  // namespace workbench
