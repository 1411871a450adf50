#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "ident/valve/stick_slip_valve.hpp"
#include "support/ident/problems.hpp"
#include "support/ident/published_valves.hpp"

namespace ident {
namespace {

using Values = std::vector<double>;

Values run(const ValveFriction<double>& friction, double start, const Values& u) {
  StickSlipValve<double> valve(friction, start);
  Values x;
  for (const double value : u) {
    x.push_back(valve.step(value));
  }
  return x;
}

TEST(StickSlipValve, WithoutFrictionFollowsU) {
  const Values u{0, 1, -2, 3.5, 3.5, -7};
  EXPECT_EQ(run({}, 0, u), u);
  EXPECT_EQ(run({0, 0, 0, SlipMotion::kResticks}, 0, u), u);
}

// Backlash of 2 (deadband only), stem at 0: it moves when u leaves −1 … 1 and then trails
// by 1; after the turn at 4 it waits until u < 2.
TEST(StickSlipValve, PlaysWithinTheDeadband) {
  const Values u{0.5, 1, 2, 4, 3, 2, 1, 0, 1, 2, 3};
  const Values x{0, 0, 1, 3, 3, 3, 2, 1, 1, 1, 2};
  EXPECT_EQ(run({2, 0, 0, SlipMotion::kSlides}, 0, u), x);
  EXPECT_EQ(run({2, 0, 0, SlipMotion::kResticks}, 0, u), x);
}

// F = 2, J = 1: S = 3. From rest it breaks at u > F/2 + J = 2, jumps by more than
// J, then slides with u − 1. Turning at 5 (x = 4), it sticks until u < 5 − 3 and is then
// at u + 1: at u = 1.9 that is 2.9, a jump of J = 1 (and 0.1 of u).
TEST(StickSlipValve, SlidesAfterTheSlip) {
  const Values u{1, 2, 2.5, 3, 5, 4, 2, 1.9, 1, 0, 2.5, 3, 3.5};
  const Values x{0, 0, 1.5, 2, 4, 4, 4, 2.9, 2, 1, 1, 1, 2.5};
  const Values found = run({2, 1, 1, SlipMotion::kSlides}, 0, u);
  for (std::size_t t = 0; t < u.size(); ++t) {
    EXPECT_NEAR(found[t], x[t], 1e-12) << t;
  }
}

// Choudhury S = 3, J = 1: F = 2. It slides as long as u rises. One sample of rest at 3
// (x = 2), and it needs the slip jump to go on: u − x > F/2 + J, that is u > 4.
TEST(StickSlipValve, StopsWhenUStops) {
  const Values u{2.5, 3, 3, 3.5, 4, 4.5, 5, 4.9, 5.4, 2, 1.5, 1, 1, 0.5, -0.5};
  const Values x{1.5, 2, 2, 2, 2, 3.5, 4, 4, 4, 4, 2.5, 2, 2, 2, 0.5};
  const Values found = run(test::from_choudhury(3.0, 1.0), 0, u);
  for (std::size_t t = 0; t < u.size(); ++t) {
    EXPECT_NEAR(found[t], x[t], 1e-12) << t;
  }
}

// He fs = 2, fd = 0.5: F = 1, J = 1.5. Breaks when |u − x| > 2, lands 0.5 behind u, and
// sticks again at once: the next step of 1 does nothing.
TEST(StickSlipValve, ResticksAfterTheSlip) {
  const Values u{1, 2, 2.1, 3, 3.6, 4, 1.5, 1, 0, -1};
  const Values x{0, 0, 1.6, 1.6, 1.6, 3.5, 3.5, 1.5, 1.5, -0.5};
  const Values found = run(test::from_he(2.0, 0.5), 0, u);
  for (std::size_t t = 0; t < u.size(); ++t) {
    EXPECT_NEAR(found[t], x[t], 1e-12) << t;
  }
}

// Equations of He 2007 as published, with their residual force.
TEST(StickSlipValve, IsHesValve) {
  test::Random random(8);
  const double fs = 1.7;
  const double fd = 0.6;
  StickSlipValve<double> valve(test::from_he(fs, fd), 0);
  double residual = 0;
  double previous_u = 0;
  double x = 0;
  double u = 0;
  for (int t = 0; t < 5000; ++t) {
    u += 0.5 * test::normal(random);
    const double force = residual + u - previous_u;
    if (std::abs(force) > fs) {
      residual = force > 0 ? fd : -fd;
      x += force - residual;
    } else {
      residual = force;
    }
    previous_u = u;
    ASSERT_NEAR(valve.step(u), x, 1e-9) << t;
  }
}

// Sticks on opening only: J_ascending = 2, no deadband. Falling u is followed.
TEST(StickSlipValve, SticksOnOneStrokeOnly) {
  const Values u{1, 2, 3, 2, 1, 2, 3, 3.5, 3.2};
  const Values x{0, 0, 3, 2, 1, 1, 1, 3.5, 3.2};
  EXPECT_EQ(run({0, 2, 0, SlipMotion::kSlides}, 0, u), x);
}

// The contract: S of a stroke is the travel of u after a reversal until the valve moves.
TEST(StickSlipValve, TravelsTheStickBandAfterAReversal) {
  const ValveFriction<double> friction{1.0, 0.5, 0.25, SlipMotion::kSlides};
  EXPECT_EQ(friction.stick_ascending(), 1.5);
  EXPECT_EQ(friction.stick_descending(), 1.25);
  StickSlipValve<double> valve(friction, 0);
  valve.step(10);
  double at = valve.step(10);
  EXPECT_EQ(at, 9.5);
  EXPECT_EQ(valve.step(10 - 1.25), 9.5);
  EXPECT_NEAR(valve.step(10 - 1.2500001), 9.25, 1e-6);  // slip of 0.25
  at = valve.step(5);
  EXPECT_EQ(valve.step(5 + 1.5), at);
  EXPECT_NEAR(valve.step(5 + 1.5000001), at + 0.5, 1e-6);
}

TEST(StickSlipValve, ConvertsPublishedParameters) {
  const auto he = test::from_he(5.0, 1.0);
  EXPECT_EQ(he.deadband, 2);
  EXPECT_EQ(he.slip_ascending, 4);
  EXPECT_EQ(he.slip_descending, 4);
  EXPECT_EQ(he.stick_ascending(), 6);  // S = fs + fd
  EXPECT_EQ(he.motion, SlipMotion::kResticks);
  const auto choudhury = test::from_choudhury(5.0, 2.0);
  EXPECT_EQ(choudhury.deadband, 3);
  EXPECT_EQ(choudhury.slip_descending, 2);
  EXPECT_EQ(choudhury.stick_descending(), 5);
  EXPECT_EQ(choudhury.motion, SlipMotion::kStops);
}

// Away from the edges of the bands both precisions do the same.
TEST(StickSlipValve, InFloatSlipsAtTheSameSamples) {
  test::Random random(9);
  for (const SlipMotion motion :
       {SlipMotion::kSlides, SlipMotion::kStops, SlipMotion::kResticks}) {
    StickSlipValve<double> valve({1.0, 0.5, 0.25, motion}, 0);
    StickSlipValve<float> valve_f({1.0F, 0.5F, 0.25F, motion}, 0);
    double u = 0;
    for (int t = 0; t < 20000; ++t) {
      u = 0.98 * u + 0.4 * test::normal(random);
      // Rounding of u, half deadband and the difference: three parts in 10⁷ of |u| ≲ 8.
      ASSERT_NEAR(valve.step(u), static_cast<double>(valve_f.step(static_cast<float>(u))),
                  3e-6);
    }
  }
}

TEST(RestingRange, HasPlacesInTheMiddleOfEqualParts) {
  const RestingRange<double> range{2, 2 + kRestingPlaces};
  EXPECT_NEAR(range.place(0), 2.5, 1e-9);
  EXPECT_NEAR(range.place(kRestingPlaces - 1), 1.5 + kRestingPlaces, 1e-9);
}

// A stem at either end of the range holds, one beyond it slips.
TEST(RestingRange, EndsWhereTheStemGivesWay) {
  const ValveFriction<double> friction{1, 3, 2, SlipMotion::kResticks};
  const auto range = resting_range(friction, 10.0);
  EXPECT_EQ(range.lowest, 6.5);
  EXPECT_EQ(range.highest, 12.5);
  EXPECT_EQ(range.at(0.5), 9.5);
  for (const double position : {range.lowest, range.highest}) {
    EXPECT_EQ(StickSlipValve<double>(friction, position).step(10), position);
  }
  EXPECT_NE(StickSlipValve<double>(friction, 6.4).step(10), 6.4);
  EXPECT_NE(StickSlipValve<double>(friction, 12.6).step(10), 12.6);
}

}  // namespace
}  // namespace ident
