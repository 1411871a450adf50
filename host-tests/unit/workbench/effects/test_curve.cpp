// Curves of storages against their closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "workbench/effects/curve.hpp"

namespace workbench {
namespace {

TEST(Curve, KeepsItsEndsAndBendsBetween) {
  std::vector<double> u = {10, 20, 30};
  Curve{std::log(4.0), 10, 30}.bend(u);
  EXPECT_NEAR(u[0], 10, 1e-12);
  EXPECT_NEAR(u[1], 10 + 20 * (2.0 - 1) / (4 - 1), 1e-12);
  EXPECT_NEAR(u[2], 30, 1e-12);
  std::vector<double> straight = {10, 20, 30};
  Curve{0, 10, 30}.bend(straight);
  EXPECT_EQ(straight[1], 20);
}

// Outflow 2H(√(1 + z/H) − 1): content z over outflow q is q + q²/4H.
TEST(Curve, ByHeadIsTheContentOfATankOverItsOutflow) {
  constexpr double kHead = 5;
  const auto content = [](double q) { return q + q * q / (4 * kHead); };
  const auto steepness = [](double q) { return 1 + q / (2 * kHead); };
  const Curve curve{std::log(steepness(8) / steepness(0)), 0, 8, true};
  const double scale = content(8) / 8;
  std::vector<double> z = {0, 2, 5, 8, -40};
  curve.bend(z);
  for (const std::size_t i : {0u, 1u, 2u, 3u}) {
    const double q = std::vector<double>{0, 2, 5, 8}[i];
    EXPECT_NEAR(scale * z[i], content(q), 1e-9) << q;
    EXPECT_NEAR(scale * curve.slope(q), steepness(q), 1e-9) << q;
  }
  EXPECT_NEAR(scale * z[4], content(-2 * kHead), 1e-9);
}

TEST(CurveSlope, IsTheSlopeOfTheCurve) {
  for (const Curve& curve : {Curve{1.5, 10, 30}, Curve{-4, 0, 2}, Curve{0, 1, 2},
                             Curve{3, -1, 5, true}, Curve{-2, 0, 8, true}}) {
    const CurveSlope slope(curve);
    for (int i = -20; i <= 120; ++i) {
      const double z = curve.from + i * (curve.to - curve.from) / 100;
      const double is = curve.slope(z);
      EXPECT_NEAR(slope(z), is, 2e-5 * is) << curve.curvature << " at " << z;
    }
  }
}

}  // namespace
}  // namespace workbench
