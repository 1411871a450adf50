#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "ident/valve/valve_grid.hpp"

namespace ident {
namespace {

constexpr int kSliding = 177;

TEST(SlidingStart, IsTheLinearValveFirst) {
  ValveForm form = ValveForm::kMixed;
  ValveFriction<double> friction{1, 1, 1, SlipMotion::kStops};
  ASSERT_TRUE(sliding_start<double>(0, 0.5, form, friction));
  EXPECT_EQ(form, ValveForm::kLinear);
  EXPECT_EQ(friction.stick_ascending(), 0);
  EXPECT_EQ(friction.stick_descending(), 0);
}

TEST(SlidingStart, EndsAfter177) {
  ValveForm form;
  ValveFriction<double> friction;
  EXPECT_TRUE(sliding_start<double>(kSliding - 1, 1, form, friction));
  for (const int index : {kSliding, kSliding + 1, 100000}) {
    EXPECT_FALSE(sliding_start<double>(index, 1, form, friction)) << index;
  }
}

// 22 bands of every proportion: one for each form with one parameter, three symmetric,
// two mixed. The form leaves free what the candidate uses.
TEST(SlidingStart, StaysInItsRangeAndForm) {
  const double swing = 0.4;
  std::map<ValveForm, int> count;
  for (int index = 1; index < kSliding; ++index) {
    ValveForm form;
    ValveFriction<double> f;
    ASSERT_TRUE(sliding_start<double>(index, swing, form, f));
    ++count[form];
    EXPECT_EQ(f.motion, SlipMotion::kSlides);
    EXPECT_GE(std::min({f.deadband, f.slip_ascending, f.slip_descending}), 0);
    const double band = std::max(f.stick_ascending(), f.stick_descending());
    EXPECT_GE(band, 0.02 * swing) << index;
    EXPECT_LE(band, 1.15 * swing * (1 + 1e-12)) << index;
    switch (form) {
      case ValveForm::kBacklash:
        EXPECT_EQ(f.slip_ascending + f.slip_descending, 0);
        break;
      case ValveForm::kAscending:
        EXPECT_EQ(f.stick_descending(), 0);
        break;
      case ValveForm::kDescending:
        EXPECT_EQ(f.stick_ascending(), 0);
        break;
      case ValveForm::kSymmetric:
        EXPECT_EQ(f.slip_ascending, f.slip_descending);
        break;
      default:
        EXPECT_NE(f.slip_ascending, f.slip_descending);
    }
  }
  EXPECT_EQ(count[ValveForm::kLinear], 0);
  EXPECT_EQ(count[ValveForm::kBacklash], 22);
  EXPECT_EQ(count[ValveForm::kAscending], 22);
  EXPECT_EQ(count[ValveForm::kDescending], 22);
  EXPECT_EQ(count[ValveForm::kSymmetric], 66);
  EXPECT_EQ(count[ValveForm::kMixed], 44);
}

// By hand: share s = 1/22 gives 1.15·s·(0.4 + 0.6·s) = 0.02233…, s = 1 gives 1.15.
TEST(SlidingStart, StepsAreFinerWhereBandsAreSmall) {
  std::vector<double> bands;
  for (int index = 1; index < kSliding; index += 8) {
    ValveForm form;
    ValveFriction<double> f;
    ASSERT_TRUE(sliding_start<double>(index, 1, form, f));
    ASSERT_EQ(form, ValveForm::kBacklash);
    bands.push_back(f.deadband);
  }
  ASSERT_EQ(bands.size(), 22u);
  EXPECT_NEAR(bands.front(), 0.0223347, 1e-6);
  EXPECT_NEAR(bands.back(), 1.15, 1e-12);
  for (std::size_t k = 2; k < bands.size(); ++k) {
    EXPECT_GT(bands[k] - bands[k - 1], bands[k - 1] - bands[k - 2]);
  }
}

struct Starts {
  SlipMotion motion;
  int count;
};

class RememberingStart : public testing::TestWithParam<Starts> {};

TEST_P(RememberingStart, EndsAfterItsCount) {
  const auto [motion, count] = GetParam();
  ValveFriction<double> friction;
  double position = 0;
  EXPECT_TRUE(remembering_start<double>(count - 1, motion, 1, 0, friction, position));
  for (const int index : {count, count + 1, 100000}) {
    EXPECT_FALSE(remembering_start<double>(index, motion, 1, 0, friction, position));
  }
}

// The stem rests at `position` although u is `first_u`: inside the band, never beyond it.
TEST_P(RememberingStart, StaysInItsRangeAndTheStemInItsBand) {
  const auto [motion, count] = GetParam();
  const double swing = 0.6;
  const double first_u = 0.3;
  double smallest = 1e9;
  double largest = 0;
  for (int index = 0; index < count; ++index) {
    ValveFriction<double> f;
    double position = 0;
    ASSERT_TRUE(remembering_start<double>(index, motion, swing, first_u, f, position));
    EXPECT_EQ(f.motion, motion);
    EXPECT_GE(std::min({f.deadband, f.slip_ascending, f.slip_descending}), 0);
    const double band = std::max(f.stick_ascending(), f.stick_descending());
    smallest = std::min(smallest, band);
    largest = std::max(largest, band);
    EXPECT_LT(first_u - position, f.deadband / 2 + f.slip_ascending) << index;
    EXPECT_LT(position - first_u, f.deadband / 2 + f.slip_descending) << index;
    StickSlipValve<double> valve(f, position);
    EXPECT_EQ(valve.step(first_u), position) << index;
  }
  EXPECT_NEAR(smallest, 0.1 * swing, 1e-12);
  // 0.1·1.1²⁶ = 1.1918…
  EXPECT_NEAR(largest, 0.1 * std::pow(1.1, 26) * swing, 1e-12);
  EXPECT_LT(largest, 1.2 * swing);
}

TEST_P(RememberingStart, FollowsTheFirstU) {
  const auto [motion, count] = GetParam();
  for (int index = 0; index < count; index += 7) {
    ValveFriction<double> f;
    double at_zero = 0;
    double at_two = 0;
    ASSERT_TRUE(remembering_start<double>(index, motion, 1, 0, f, at_zero));
    ASSERT_TRUE(remembering_start<double>(index, motion, 1, 2, f, at_two));
    EXPECT_NEAR(at_two, at_zero + 2, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Motions, RememberingStart,
                         testing::Values(Starts{SlipMotion::kStops, 486},
                                         Starts{SlipMotion::kResticks, 3402}));

// Proportion {0, 1, 1}, band 0.1, first u 0: the stem is tried at the middles of 24 equal
// parts of −0.1 … 0.1.
TEST(RememberingStarts, SpreadTheStemAcrossTheBand) {
  for (int k = 0; k < 24; ++k) {
    ValveFriction<double> f;
    double position = 0;
    ASSERT_TRUE(remembering_start<double>(k, SlipMotion::kResticks, 1, 0, f, position));
    EXPECT_NEAR(f.slip_ascending, 0.1, 1e-12);
    EXPECT_EQ(f.deadband, 0);
    EXPECT_NEAR(position, -0.1 + 0.2 * (k + 0.5) / 24, 1e-12);
  }
}

}  // namespace
}  // namespace ident
