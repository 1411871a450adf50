#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "ident/base/pattern_search.hpp"

namespace ident {
namespace {

using Pattern = PatternSearch<double>;
using Point = Pattern::Point;

int minimise(Pattern& search, const std::function<double(const Point&)>& objective) {
  int evaluations = 0;
  while (!search.done()) {
    const Point point = search.propose();
    search.report(point, objective(point));
    ++evaluations;
  }
  return evaluations;
}

double bowl(const Point& p) {
  return (p[0] - 1) * (p[0] - 1) + 10 * (p[1] + 2) * (p[1] + 2) + p[0] * p[1];
}

// ∂/∂p₀: 2p₀ − 2 + p₁ = 0, ∂/∂p₁: 20p₁ + 40 + p₀ = 0: p₀ = 80/39, p₁ = −82/39.
TEST(PatternSearch, FindsTheBottomOfABowl) {
  Pattern search;
  search.start({}, bowl({}), 1000);
  search.add_direction({1}, 0.5, 1e-5);
  search.add_direction({0, 1}, 0.5, 1e-5);
  EXPECT_LT(minimise(search, bowl), 300);
  EXPECT_NEAR(search.best()[0], 80.0 / 39, 1e-3);
  EXPECT_NEAR(search.best()[1], -82.0 / 39, 1e-3);
  EXPECT_EQ(search.best_value(), bowl(search.best()));
}

// Steps of 0.05 hide the slope from a search with smaller steps.
TEST(PatternSearch, DescendsAStaircase) {
  const auto stairs = [](const Point& p) {
    return std::abs(std::floor((p[0] - 3) / 0.05)) + std::abs(std::floor(p[1] / 0.05));
  };
  Pattern search;
  search.start({0, 2}, stairs({0, 2}), 500);
  search.add_direction({1}, 0.4, 0.02);
  search.add_direction({0, 1}, 0.4, 0.02);
  minimise(search, stairs);
  EXPECT_NEAR(search.best()[0], 3, 0.1);
  EXPECT_NEAR(search.best()[1], 0, 0.1);
}

// From (1, 1) no single coordinate goes down |p₀ − p₁| + 0.1·(p₀ + p₁), both together do.
TEST(PatternSearch, UsesSlantedDirections) {
  const auto ridge = [](const Point& p) {
    return std::abs(p[0] - p[1]) + 0.1 * std::abs(p[0] + p[1]);
  };
  Pattern straight;
  straight.start({1, 1}, 0.2, 500);
  straight.add_direction({1}, 0.25, 0.001);
  straight.add_direction({0, 1}, 0.25, 0.001);
  minimise(straight, ridge);
  EXPECT_EQ(straight.best_value(), 0.2);
  Pattern slanted;
  slanted.start({1, 1}, 0.2, 500);
  slanted.add_direction({1, 1}, 0.25, 0.001);
  minimise(slanted, ridge);
  EXPECT_LT(slanted.best_value(), 0.001);
}

TEST(PatternSearch, KeepsToItsNumberOfEvaluations) {
  const auto slope = [](const Point& p) { return p[0]; };
  Pattern search;
  search.start({}, 0, 17);
  search.add_direction({1}, 1, 1e-12);
  EXPECT_EQ(minimise(search, slope), 17);
}

TEST(PatternSearch, EndsWhenNoStepHelps) {
  Pattern search;
  search.start({}, 0, 1000);
  search.add_direction({1}, 1, 0.25);
  search.add_direction({0, 1}, 1, 0.5);
  // Both senses at 1, ½, ¼ and at 1, ½.
  EXPECT_EQ(minimise(search, [](const Point&) { return 1.0; }), 10);
  EXPECT_EQ(search.best_value(), 0);
}

TEST(PatternSearch, IsDoneWithoutDirectionsOrEvaluations) {
  Pattern search;
  EXPECT_TRUE(search.done());
  search.start({1}, 5, 100);
  EXPECT_TRUE(search.done());
  EXPECT_EQ(search.best()[0], 1);
  search.start({1}, 5, 0);
  search.add_direction({1}, 1, 0.1);
  EXPECT_TRUE(search.done());
}

TEST(PatternSearch, NeverTakesWhatIsNotANumber) {
  Pattern search;
  search.start({}, 3, 50);
  search.add_direction({1}, 1, 0.1);
  minimise(search, [](const Point&) { return std::nan(""); });
  EXPECT_EQ(search.best_value(), 3);
}

// The caller may move a proposal into its bounds and report where it went.
TEST(PatternSearch, TakesThePointThatIsReported) {
  Pattern search;
  search.start({}, 0, 40);
  search.add_direction({1}, 1, 1e-3);
  while (!search.done()) {
    Point point = search.propose();
    point[0] = std::min(point[0], 2.5);
    search.report(point, -point[0]);
  }
  EXPECT_EQ(search.best()[0], 2.5);
}

}  // namespace
}  // namespace ident
