#include <gtest/gtest.h>

#include "ident/valve/earlier_valve.hpp"

namespace ident {
namespace {

ValveModel<double> found() {
  ValveModel<double> model;
  model.known = true;
  model.friction = {1.0, 5.0, 2.0, SlipMotion::kResticks};
  model.poles = {pole_of(80.0), pole_of(3.0)};
  model.fit.error = 35;
  return model;
}

TEST(EarlierValve, IsTheSameInAWindowOfAnotherRangeAndRate) {
  const EarlierValve earlier = earlier_valve(found(), 2, 700);
  EXPECT_NEAR(earlier.slow, 160, 1e-3);
  EXPECT_NEAR(earlier.fast, 6, 1e-4);
  const ValveModel<double> start = start_from(earlier, 10.0, 4, 350);
  EXPECT_TRUE(start.known);
  EXPECT_NEAR(start.friction.deadband, 0.1, 1e-6);
  EXPECT_NEAR(start.friction.slip_ascending, 0.5, 1e-6);
  EXPECT_NEAR(start.friction.slip_descending, 0.2, 1e-6);
  EXPECT_EQ(start.friction.motion, SlipMotion::kResticks);
  EXPECT_NEAR(time_constant_of(start.poles.slow), 40, 1e-3);
  EXPECT_NEAR(time_constant_of(start.poles.fast), 1.5, 1e-4);
  EXPECT_NEAR(start.fit.error, 17.5, 1e-4);
}

TEST(EarlierValve, KeepsAnIntegratorAndAMissingPole) {
  ValveModel<double> model = found();
  model.poles = {1.0, 0.0};
  const ValveModel<double> start = start_from(earlier_valve(model, 1, 100), 1.0, 3, 100);
  EXPECT_EQ(start.poles.slow, 1);
  EXPECT_EQ(start.poles.fast, 0);
}

TEST(EarlierValve, IsTrustedWhenASearchFindsItAgain) {
  const EarlierValve first = earlier_valve(found(), 1, 100);
  const EarlierValve once = next_earlier({}, first, true);
  EXPECT_EQ(once.trusted, 0);
  const EarlierValve twice = next_earlier(once, first, true);
  EXPECT_EQ(twice.trusted, kTrustedWindows);
  EXPECT_EQ(next_earlier(twice, first, false).trusted, kTrustedWindows - 1);
}

TEST(EarlierValve, IsNotTrustedAfterAJump) {
  const EarlierValve first = earlier_valve(found(), 1, 100);
  const EarlierValve trusted = next_earlier(first, first, true);
  ValveModel<double> other = found();
  other.friction.deadband = 2;
  EXPECT_EQ(next_earlier(trusted, earlier_valve(other, 1, 100), true).trusted, 0);
}

TEST(EarlierValve, OutlivesAWindowWithoutOne) {
  const EarlierValve trusted =
      next_earlier(earlier_valve(found(), 1, 100), earlier_valve(found(), 1, 100), true);
  const EarlierValve after = next_earlier(trusted, {}, true);
  EXPECT_TRUE(after.known());
  EXPECT_EQ(after.trusted, trusted.trusted);
}

// The same bands of a window that found no valve say nothing.
TEST(EarlierValve, IsTheSameOnlyIfBothAreKnown) {
  const EarlierValve known = earlier_valve(found(), 1, 100);
  EarlierValve unknown = known;
  unknown.unexplained = -1;
  EXPECT_TRUE(same_valve(known, known));
  EXPECT_FALSE(same_valve(known, unknown));
  EXPECT_FALSE(same_valve(unknown, known));
}

}  // namespace
}  // namespace ident
