#include <gtest/gtest.h>

#include "ident/evidence/band_ladder.hpp"

namespace ident {
namespace {

TEST(BandLadder, RisesBy15PercentFromTheLowestRung) {
  EXPECT_DOUBLE_EQ(rung_band<double>(0, 1), 0.0002);
  EXPECT_NEAR(rung_band<double>(1, 1), 0.00023, 1e-12);     // 0.0002 · 1.15
  EXPECT_NEAR(rung_band<double>(2, 1), 0.0002645, 1e-12);   // 0.0002 · 1.3225
  EXPECT_NEAR(rung_band<double>(10, 1), 0.00080911, 1e-8);  // 0.0002 · 4.04556
  EXPECT_NEAR(rung_band<double>(20, 1), 0.00327331, 1e-8);  // 0.0002 · 16.36654
  EXPECT_NEAR(rung_band<double>(40, 1), 0.05357271, 1e-7);  // 0.0002 · 267.8635
}

// A valve whose band is the whole span still has neighbours on both sides.
TEST(BandLadder, ReachesASixthAboveTheSpan) {
  EXPECT_NEAR(rung_band<double>(kRungs - 1, 1), 1.1596, 1e-4);
  EXPECT_LT(rung_band<double>(kRungs - 3, 1), 1);
}

TEST(BandLadder, IsInTheUnitOfTheSpan) {
  for (const int rung : {0, 7, 31, 48}) {
    EXPECT_DOUBLE_EQ(rung_band<double>(rung, 40), 40 * rung_band<double>(rung, 1));
  }
}

TEST(BandLadder, HasPlayAndAStemThatSlips) {
  const ValveFriction<double> play = rung_valve<double>(20, 0, 1);
  EXPECT_NEAR(play.deadband, 0.00327331, 1e-8);
  EXPECT_EQ(play.slip_ascending, 0);
  EXPECT_EQ(play.slip_descending, 0);
  const ValveFriction<double> slips = rung_valve<double>(20, 1, 1);
  EXPECT_NEAR(slips.deadband, 0.00130932, 1e-8);        // 40 % of it
  EXPECT_NEAR(slips.slip_ascending, 0.00196398, 1e-8);  // 60 %
  EXPECT_EQ(slips.slip_ascending, slips.slip_descending);
}

TEST(BandLadder, GivesEveryValveTheBandOfItsRungOnBothStrokes) {
  for (int rung = 0; rung < kRungs; ++rung) {
    for (int slip = 0; slip < kSlips; ++slip) {
      const ValveFriction<double> valve = rung_valve<double>(rung, slip, 12);
      const double band = rung_band<double>(rung, 12);
      EXPECT_NEAR(valve.stick_ascending(), band, 1e-12 * band);
      EXPECT_NEAR(valve.stick_descending(), band, 1e-12 * band);
      EXPECT_EQ(valve.motion, SlipMotion::kSlides);
    }
  }
}

TEST(BandLadder, IsTheSameInFloat) {
  for (int rung = 0; rung < kRungs; ++rung) {
    const double band = rung_band<double>(rung, 1);
    EXPECT_NEAR(static_cast<double>(rung_band<float>(rung, 1)), band, 2e-5 * band);
    const double slip = rung_valve<double>(rung, 1, 1).slip_descending;
    EXPECT_NEAR(static_cast<double>(rung_valve<float>(rung, 1, 1).slip_descending), slip,
                2e-5 * slip);
  }
}

}  // namespace
}  // namespace ident
