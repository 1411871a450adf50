// One factor for several targets.
#include <gtest/gtest.h>

#include <cmath>

#include "workbench/model/base/least_squares.hpp"
#include "workbench/model/base/normal_equations.hpp"

namespace workbench {
namespace {

TEST(NormalEquations, SayOfEachTargetWhatLeastSquaresSays) {
  constexpr std::size_t kCount = 90;
  std::vector<std::vector<double>> signals(3, std::vector<double>(kCount));
  std::vector<double> first(kCount);
  std::vector<double> second(kCount);
  for (std::size_t k = 0; k < kCount; ++k) {
    const auto t = static_cast<double>(k);
    signals[0][k] = 1;
    signals[1][k] = std::sin(t / 5);
    signals[2][k] = k < 20 ? std::exp(-t / 4) : 0;
    first[k] = 2 + 3 * signals[1][k] - signals[2][k];
    second[k] = std::cos(t / 9);
  }
  const std::vector<std::span<const double>> columns(signals.begin(), signals.end());
  const std::vector<Block> rows = {{0, 30, true}, {30, 50, false}, {50, kCount, true}};
  const std::vector<SampleRange> extents = {{0, kCount}, {0, kCount}, {0, 20}};
  const NormalEquations equations(columns, rows, extents);
  for (const std::vector<double>* target : {&first, &second}) {
    EXPECT_EQ(equations.solve(*target), least_squares(columns, *target, rows, extents));
  }
  const std::vector<double> found = equations.solve(first);
  EXPECT_NEAR(found[0], 2, 1e-9);
  EXPECT_NEAR(found[1], 3, 1e-9);
  EXPECT_NEAR(found[2], -1, 1e-9);
}

TEST(NormalEquations, AColumnThatTheOthersExplainGetsNothing) {
  const std::vector<double> one(10, 1.0);
  const std::vector<double> two(10, 2.0);
  const std::vector<std::span<const double>> columns = {one, two};
  const std::vector<Block> rows = {{0, 10, true}};
  const std::vector<double> found = NormalEquations(columns, rows, {}).solve(two);
  EXPECT_NEAR(found[0], 2, 1e-12);
  EXPECT_EQ(found[1], 0);
}

}  // namespace
}  // namespace workbench
