// Small least squares against solutions known in advance.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "workbench/model/base/least_squares.hpp"

namespace workbench {
namespace {

TEST(LeastSquares, FindsTheCoefficientsOnTheEstimationBlocksAlone) {
  std::vector<double> a(100);
  std::vector<double> b(100, 1.0);
  std::vector<double> target(100);
  for (std::size_t k = 0; k < 100; ++k) {
    a[k] = std::sin(0.3 * static_cast<double>(k));
    target[k] = k < 60 ? 3 * a[k] - 2 : 1e6;
  }
  const std::vector<Block> rows = {{0, 60, true}, {60, 100, false}};
  const std::vector<std::span<const double>> columns = {a, b};
  const auto c = least_squares(columns, target, rows);
  EXPECT_NEAR(c[0], 3, 1e-10);
  EXPECT_NEAR(c[1], -2, 1e-10);
  std::vector<double> residual(100);
  for (std::size_t k = 0; k < 100; ++k) residual[k] = target[k] - c[0] * a[k] - c[1];
  EXPECT_NEAR(sum_of_squares(residual, rows), 0, 1e-18);
}

TEST(LeastSquares, LeavesOutAColumnThatOthersExplain) {
  const std::vector<double> a = {1, 2, 3, 4};
  const std::vector<double> twice = {2, 4, 6, 8};
  const std::vector<double> zero(4, 0.0);
  const std::vector<double> target = {5, 10, 15, 20};
  const std::vector<std::span<const double>> columns = {a, twice, zero};
  const std::vector<Block> rows = {{0, 4, true}};
  const auto c = least_squares(columns, target, rows);
  EXPECT_NEAR(c[0] + 2 * c[1], 5, 1e-9);
  EXPECT_EQ(c[2], 0);
}

TEST(LeastSquares, InvertsAndDotsAsByHand) {
  const auto inverse = inverse_spd({4, 1, 1, 2}, 2);
  EXPECT_NEAR(inverse[0], 2.0 / 7, 1e-12);
  EXPECT_NEAR(inverse[1], -1.0 / 7, 1e-12);
  EXPECT_NEAR(inverse[3], 4.0 / 7, 1e-12);
  const std::vector<double> five = {1, 2, 3, 4, 5};
  EXPECT_DOUBLE_EQ(dot(five, five), 55);
}

}  // namespace
}  // namespace workbench
