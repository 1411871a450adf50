// Two straight pieces with a dead one between them.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "workbench/effects/two_pieces.hpp"

namespace workbench {
namespace {

TEST(TwoPieces, BothEndsStayAndNothingChangesBetween) {
  const TwoPieces curve(20, 80, 50, 12, 1);
  EXPECT_DOUBLE_EQ(curve.below(), 44);
  EXPECT_DOUBLE_EQ(curve.above(), 56);
  std::vector<double> u = {10, 20, 44, 50, 56, 80, 90};
  curve.bend(u);
  EXPECT_DOUBLE_EQ(u[0], 20) << "as at the end";
  EXPECT_DOUBLE_EQ(u[1], 20);
  EXPECT_DOUBLE_EQ(u[2], u[4]);
  EXPECT_DOUBLE_EQ(u[3], 50) << "both pieces are as long";
  EXPECT_DOUBLE_EQ(u[5], 80);
  EXPECT_DOUBLE_EQ(u[6], 80);
}

TEST(TwoPieces, AboveTheSlopeIsAnotherByTheRatio) {
  const TwoPieces curve(0, 100, 25, 0, 3);
  const double below = curve.share(0.2) - curve.share(0.1);
  const double above = curve.share(0.6) - curve.share(0.5);
  EXPECT_NEAR(above / below, 3, 1e-12);
  EXPECT_NEAR(curve.share(1), 1, 1e-12);
  EXPECT_EQ(curve.share(NAN), 0);
}

TEST(TwoPieces, ADeadPieceMayReachTheEnds) {
  const TwoPieces all(0, 100, 50, 300, 1);
  EXPECT_EQ(all.share(0.3), 0);
  EXPECT_EQ(all.share(1), 0);
  const TwoPieces seat(0, 100, 0, 20, 1);
  EXPECT_EQ(seat.share(0.1), 0);
  EXPECT_NEAR(seat.share(1), 1, 1e-12);
}

}  // namespace
}  // namespace workbench
