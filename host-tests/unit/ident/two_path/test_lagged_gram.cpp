#include <gtest/gtest.h>

#include "ident/two_path/lagged_gram.hpp"
#include "support/ident/all_at_once.hpp"
#include "support/ident/loop.hpp"

namespace ident {
namespace {

TEST(KnotGrid, SharesASampleBetweenTwoHats) {
  const auto grid = test::uniform_grid<double>(2, 4);
  EXPECT_EQ(grid.hats(), 8);
  const auto expect = [&](double u, bool ascending, int first, double upper) {
    const HatPair<double> pair = grid.at(u, ascending);
    EXPECT_EQ(pair.first, first) << u;
    EXPECT_DOUBLE_EQ(pair.upper, upper) << u;
  };
  // Knots 0, ½, 1 are hats 0 … 2; knots 0, ¼, ½, ¾, 1 are hats 3 … 7.
  expect(0.25, true, 0, 0.5);
  expect(0.625, true, 1, 0.25);
  expect(0.5, true, 1, 0);
  expect(-3, true, 0, 0);
  expect(7, true, 1, 1);
  expect(0.3125, false, 4, 0.25);
  expect(-1, false, 3, 0);
  expect(2, false, 6, 1);
}

// 20 samples (4 are predicted: t = 16 … 19), y(t) = t, u = ½ at one path of one segment:
// both ascending hats are ½ throughout.
TEST(LaggedGram, OfAConstantValve) {
  static_assert(LaggedGram<double>::kFirst == 16);
  test::Window w;
  for (int t = 0; t < 20; ++t) {
    w.u.push_back(0.5);
    w.y.push_back(t);
    w.ascending.push_back(1);
  }
  static LaggedGram<double> gram;
  test::accumulate(gram, test::uniform_grid<double>(1, 1), w.view());
  EXPECT_EQ(gram.rows(), 4);
  EXPECT_EQ(gram.y_sum(0), 16 + 17 + 18 + 19);
  EXPECT_EQ(gram.y_sum(4), 12 + 13 + 14 + 15);
  EXPECT_EQ(gram.yy(0, 1), 16 * 15 + 17 * 16 + 18 * 17 + 19 * 18);
  EXPECT_EQ(gram.yy(1, 0), gram.yy(0, 1));
  HatColumn<double> out = HatColumn<double>::Zero(4);
  gram.add_hat_sum(3, 2.0, out);
  EXPECT_EQ(out(0), 2 * 4 * 0.5);
  EXPECT_EQ(out(1), 2 * 4 * 0.5);
  EXPECT_EQ(out(2), 0);
  out.setZero();
  gram.add_y_hats(1, 2, 1.0, out);  // Σ y(t−1)·½
  EXPECT_EQ(out(0), 0.5 * (15 + 16 + 17 + 18));
  HatSquare<double> square = HatSquare<double>::Zero(4, 4);
  gram.filtered(0, 2, {3, 1, 0, 0}, square);  // (3 + 1)²·¼·4 rows
  EXPECT_EQ(square(0, 0), 16);
  EXPECT_EQ(square(0, 1), 16);
  EXPECT_EQ(square(3, 3), 0);
  HatColumn<double> x = HatColumn<double>::Zero(4);
  x(0) = 2;
  x(1) = 4;
  EXPECT_EQ(gram.xx(1, 1, x), 4 * 9.0);
  EXPECT_EQ(gram.xx(2, 5, x), 4 * 9.0);
}

TEST(LaggedGram, MayBeUsedAgain) {
  test::Random random(10);
  const test::Window first = test::random_window(random, 80);
  const test::Window second = test::random_window(random, 60);
  const auto grid = test::uniform_grid<double>(3, 2);
  static LaggedGram<double> used;
  static LaggedGram<double> fresh;
  test::accumulate(used, test::uniform_grid<double>(kMaxSegments, kMaxSegments),
                   first.view());
  test::accumulate(used, grid, second.view());
  test::accumulate(fresh, grid, second.view());
  HatSquare<double> a = HatSquare<double>::Zero(7, 7);
  HatSquare<double> b = a;
  used.filtered(2, 3, {1, 2, 3, 4}, a);
  fresh.filtered(2, 3, {1, 2, 3, 4}, b);
  EXPECT_TRUE(a == b);
  EXPECT_EQ(used.yy(2, 3), fresh.yy(2, 3));
}

}  // namespace
}  // namespace ident
