#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <vector>

#include "ident/two_path/two_path_model.hpp"
#include "support/ident/problems.hpp"
#include "support/ident/two_path_reference.hpp"

namespace ident {
namespace {

using Values = std::vector<double>;

Process<double> process_of(const Values& a, const Values& b, int nk, double d) {
  Process<double> p;
  p.na = static_cast<int>(a.size());
  p.nb = static_cast<int>(b.size());
  p.nk = nk;
  p.d = d;
  std::copy(a.begin(), a.end(), p.a.begin());
  std::copy(b.begin(), b.end(), p.b.begin());
  return p;
}

TEST(Path, IsStraightBetweenKnotsAndConstantOutside) {
  Path<double> path;
  path.segments = 2;
  path.knots = {1, 2, 4};
  path.x = {10, 20, 10};
  const std::array<std::array<double, 2>, 8> points{
      {{0, 10}, {1, 10}, {1.5, 15}, {2, 20}, {2.5, 17.5}, {3, 15}, {4, 10}, {9, 10}}};
  for (const auto& [u, x] : points) {
    EXPECT_DOUBLE_EQ(path.at(u), x) << u;
  }
}

TEST(Path, OfOneSegment) {
  Path<float> path;
  path.knots = {0, 2};
  path.x = {-1, 1};
  EXPECT_FLOAT_EQ(path.at(0.5F), -0.5F);
  EXPECT_FLOAT_EQ(path.at(-3.0F), -1.0F);
  EXPECT_FLOAT_EQ(path.at(3.0F), 1.0F);
}

// y(t) = 0.5·y(t−1) + 2·x(t−2) + 1·x(t−3) + 0.25, x held at its first value before.
//   x = 1 0 0 0 0 0:  inputs 3, 3, 3, 1, 0, 0 (two lags of dead time in all)
//   y = 3.25, 1.625+3.25, …
TEST(FreeRun, FollowsTheHandWorkedSequence) {
  const auto p = process_of({-0.5}, {2, 1}, 1, 0.25);
  const Values x{1, 0, 0, 0, 0, 0};
  Values y(6);
  test::free_run<double>(p, x, {}, y);
  // t=0: 3 + .25; t=1: 1.625 + 3.25; t=2: x(0)·2 + x(0)·1; t=3: x(1)·2 + x(0)·1; …
  const Values expected{3.25, 4.875, 5.6875, 4.09375, 2.296875, 1.3984375};
  for (std::size_t t = 0; t < y.size(); ++t) {
    EXPECT_DOUBLE_EQ(y[t], expected[t]) << t;
  }
}

// Two lags of y: y(t) = y(t−1) − 0.5·y(t−2) + x(t−1), initial additions 1 and −1.
//   t=0: 0 + 1 = 1;  t=1: 1 + 0 − 1 = 0;  t=2: 0 − 0.5 = −0.5;  t=3: −0.5;  t=4: −0.25
TEST(FreeRun, AddsTheInitialState) {
  const auto p = process_of({-1, 0.5}, {1}, 0, 0);
  const Values x(5, 0.0);
  const Values initial{1, -1};
  Values y(5);
  test::free_run<double>(p, x, initial, y);
  EXPECT_EQ(y, (Values{1, 0, -0.5, -0.5, -0.25}));
}

TEST(FreeRun, SettlesAtTheSteadyGain) {
  const auto p = process_of({-0.5, 0.1}, {0.3, 0.3}, 3, 0.6);
  const Values x(200, 2.0);
  Values y(200);
  test::free_run<double>(p, x, {}, y);
  EXPECT_NEAR(y.back(), (0.6 * 2 + 0.6) / 0.6, 1e-12);
}

TEST(FreeRun, InFloatStaysWithinRounding) {
  test::Random random(5);
  const auto p = process_of({-1.5, 0.7, -0.1}, {0.2, 0.1, 0.1}, 4, 0.1);
  Process<float> pf;
  pf.na = p.na;
  pf.nb = p.nb;
  pf.nk = p.nk;
  pf.d = static_cast<float>(p.d);
  for (int i = 0; i < kMaxNa; ++i) {
    pf.a[i] = static_cast<float>(p.a[i]);
    pf.b[i] = static_cast<float>(p.b[i]);
  }
  Values x(3000);
  for (double& value : x) {
    value = test::normal(random);
  }
  const std::vector<float> xf = test::as<float>(x);
  Values y(x.size());
  std::vector<float> yf(x.size());
  test::free_run<double>(p, x, {}, y);
  test::free_run<float>(pf, xf, {}, yf);
  // About ten roundings of |y| ≲ 5 a sample, amplified by Σ|h| ≈ 10.
  for (std::size_t t = 0; t < y.size(); ++t) {
    ASSERT_NEAR(y[t], static_cast<double>(yf[t]), 10 * 10 * 5 * 6e-8) << t;
  }
}

TEST(IsStable, OfOneLag) {
  EXPECT_TRUE(is_stable(process_of({-0.999}, {1}, 0, 0)));
  EXPECT_TRUE(is_stable(process_of({0.999}, {1}, 0, 0)));
  EXPECT_FALSE(is_stable(process_of({-1}, {1}, 0, 0)));
  EXPECT_FALSE(is_stable(process_of({1.5}, {1}, 0, 0)));
  EXPECT_FALSE(is_stable(process_of({-0.95}, {1}, 0, 0), 0.1));
  EXPECT_TRUE(is_stable(process_of({-0.85}, {1}, 0, 0), 0.1));
}

// z² + a₁z + a₂: the triangle |a₂| < 1, |a₁| < 1 + a₂.
TEST(IsStable, IsTheTriangleForTwoLags) {
  for (double a1 = -2.43; a1 < 2.5; a1 += 0.1) {
    for (double a2 = -1.45; a2 < 1.5; a2 += 0.1) {
      const bool inside = std::abs(a2) < 1 && std::abs(a1) < 1 + a2;
      EXPECT_EQ(is_stable(process_of({a1, a2}, {1}, 0, 0)), inside) << a1 << ' ' << a2;
    }
  }
}

TEST(IsStable, RefusesWhatIsNotANumber) {
  EXPECT_FALSE(is_stable(process_of({std::nan("")}, {1}, 0, 0)));
  EXPECT_FALSE(is_stable(process_of({0, INFINITY}, {1}, 0, 0)));
}

TEST(IsStable, AgreesWithTheEigenvaluesOfTheCompanionMatrix) {
  test::Random random(6);
  int stable = 0;
  for (int k = 0; k < 20000; ++k) {
    const int na = 1 + static_cast<int>(random() % kMaxNa);
    Values a(na);
    for (double& value : a) {
      value = test::uniform(random, -2, 2) / (k % 3 + 1);
    }
    Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(na, na);
    for (int i = 0; i < na; ++i) {
      companion(0, i) = -a[i];
      if (i > 0) {
        companion(i, i - 1) = 1;
      }
    }
    const double radius = companion.eigenvalues().cwiseAbs().maxCoeff();
    if (std::abs(radius - 0.999) < 1e-9) {
      continue;
    }
    const bool found = is_stable(process_of(a, {1}, 0, 0), 0.001);
    ASSERT_EQ(found, radius < 0.999) << k << " radius " << radius;
    stable += found ? 1 : 0;
  }
  EXPECT_GT(stable, 2000);
}

}  // namespace
}  // namespace ident
