// Controller outputs that rest at their limit, and others that only rest.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "workbench/recording/output_limit.hpp"

namespace workbench {
namespace {

std::vector<double> output_sine(double low, double high) {
  std::vector<double> u;
  for (int k = 0; k < 600; ++k)
    u.push_back(std::clamp(std::sin(0.1 * k + 0.003), low, high));
  return u;
}

TEST(OutputLimit, IsAnEndThatACycleRestsAt) {
  const std::vector<OutputLimit> limits = limits_of_output(output_sine(-0.8, 2));
  ASSERT_EQ(limits.size(), 1u);
  EXPECT_DOUBLE_EQ(limits[0].level, -0.8);
  EXPECT_FALSE(limits[0].upper);
  EXPECT_EQ(limits[0].stays, 9u);
  EXPECT_NEAR(limits[0].share, 0.205, 0.02);
  EXPECT_EQ(limits_of_output(output_sine(-0.8, 0.9)).size(), 2u);
}

TEST(OutputLimit, IsNotTheTopOfAnySwing) {
  EXPECT_TRUE(limits_of_output(output_sine(-2, 2)).empty());
  EXPECT_TRUE(limits_of_output({}).empty());
  EXPECT_TRUE(limits_of_output(std::vector<double>(50, 3.0)).empty());
}

TEST(OutputLimit, IsNotALevelOfStepsOfASwitchOrOfARounding) {
  std::vector<double> steps;
  std::vector<double> relay;
  std::vector<double> rounded;
  for (int k = 0; k < 600; ++k) {
    constexpr double kLevels[] = {50, 60, 50, 55, 50, 60};
    steps.push_back(kLevels[k / 100]);
    relay.push_back(k / 20 % 2);
    rounded.push_back(std::round(2 * std::sin(0.05 * k)));
  }
  EXPECT_TRUE(limits_of_output(steps).empty());
  EXPECT_TRUE(limits_of_output(relay).empty());
  EXPECT_TRUE(limits_of_output(rounded).empty());
}

}  // namespace
}  // namespace workbench
