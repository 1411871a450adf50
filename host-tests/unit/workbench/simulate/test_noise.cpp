#include <gtest/gtest.h>

#include <cmath>

#include "workbench/simulate/cycles.hpp"
#include "workbench/simulate/noise.hpp"
#include "workbench/simulate/random.hpp"

namespace workbench {
namespace {

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

}  // namespace
}  // namespace workbench
