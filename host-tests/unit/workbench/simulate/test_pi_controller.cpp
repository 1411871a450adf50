#include <gtest/gtest.h>

#include "workbench/simulate/pi_controller.hpp"

namespace workbench {
namespace {

TEST(SimulatePiController, VelocityFormByHand) {
  // gain 2, period / reset time = 0.1.
  PiController controller({2, 5, -1e300, 1e300}, 0.5, 10);
  EXPECT_NEAR(controller.step(1, 0), 10 + 2 * (1 + 0.1), 1e-12);
  EXPECT_NEAR(controller.step(1, 0.5), 12.2 + 2 * (-0.5 + 0.1 * 0.5), 1e-12);
  EXPECT_NEAR(controller.step(1, 1), 11.3 + 2 * -0.5, 1e-12);
}

TEST(SimulatePiController, ClipsAndDoesNotWindUp) {
  PiController controller({1, 1, 0, 20}, 1, 10);
  EXPECT_DOUBLE_EQ(controller.step(100, 0), 20);
  EXPECT_DOUBLE_EQ(controller.step(100, 0), 20);
  // e falls from 100 to -1: leaves the limit at once.
  EXPECT_DOUBLE_EQ(controller.step(0, 1), 0);
}

TEST(SimulatePiController, GapActionSeesOnlyWhatIsBeyondTheGap) {
  PiController controller({2, 5, -1e300, 1e300, 0.5}, 0.5, 10);
  EXPECT_DOUBLE_EQ(controller.step(0, 0.5), 10);
  EXPECT_DOUBLE_EQ(controller.step(0, -0.4), 10);
  EXPECT_NEAR(controller.step(1.5, 0), 10 + 2 * (1 + 0.1), 1e-12);
  EXPECT_NEAR(controller.step(0, 0), 12.2 - 2, 1e-12);
}

}  // namespace
}  // namespace workbench
