#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "workbench/simulate/backlash_valve.hpp"
#include "workbench/simulate/coasting_valve.hpp"
#include "workbench/simulate/friction.hpp"
#include "workbench/simulate/he_valve.hpp"
#include "workbench/simulate/kano_valve.hpp"
#include "workbench/simulate/linear_valve.hpp"
#include "workbench/simulate/random.hpp"
#include "workbench/simulate/sliding_valve.hpp"

namespace workbench {
namespace {

std::vector<double> positions(Valve& valve, const std::vector<double>& signal) {
  valve.rest(0);
  std::vector<double> x;
  for (const double u : signal) x.push_back(valve.step(u));
  return x;
}

std::vector<double> random_walk(std::uint64_t seed, double step) {
  Random random("walk", seed);
  std::vector<double> u;
  double value = 0;
  for (int i = 0; i < 2000; ++i) {
    // Rests of several samples occur too.
    if (random.chance(0.8)) value += step * random.normal();
    u.push_back(value);
  }
  return u;
}

TEST(SimulateLinearValve, FollowsTheSignal) {
  LinearValve valve;
  EXPECT_EQ(positions(valve, {1, -2, 3}), (std::vector<double>{1, -2, 3}));
}

TEST(SimulateHeValve, PaperValveMovesInStepsAfterMoreThanFive) {
  HeValve valve({5, 5, 0, 0});
  EXPECT_EQ(positions(valve, {3, 5, 5.5, 10.5, 11, 7, 6, 5.9, 1, 0.5}),
            (std::vector<double>{0, 0, 5.5, 5.5, 11, 11, 11, 5.9, 5.9, 0.5}));
}

TEST(SimulateHeValve, EachStrokeHasItsOwnFriction) {
  // Up: starts above 4, stops 1 short. Down: starts beyond 2, stops 0.5 short.
  HeValve valve({4, 2, 1, 0.5});
  EXPECT_EQ(positions(valve, {4, 5, 8, 9, 6.5, 5.5, 4, 3.5}),
            (std::vector<double>{0, 4, 4, 8, 8, 6, 6, 4}));
}

TEST(SimulateHeValve, OneStickingStrokeLeavesTheOtherFree) {
  HeValve valve({5, 0, 0, 0});
  EXPECT_EQ(positions(valve, {-1, -2, -1, 3, 3.5, 3.4, 8.4, 8.5}),
            (std::vector<double>{-1, -2, -2, -2, 3.5, 3.4, 3.4, 8.5}));
}

TEST(SimulateSlidingValve, SlidesUntilTheSignalTurns) {
  // S = 5, J = 3: fs = 4, fd = 1.
  SlidingValve valve(friction_from_s_j(5, 3));
  EXPECT_EQ(positions(valve, {4, 4.5, 6, 8, 7, 3, 2.5, 1, 1, -1, -2.5}),
            // breaks free at 4.5, slides to 8; needs 5 from there: below 3; the
            // stop at 1 holds it until 3 more are travelled.
            (std::vector<double>{0, 3.5, 5, 7, 7, 7, 3.5, 2, 2, 2, -1.5}));
}

TEST(SimulateSlidingValve, NeedsOnlyTheJumpToGoOnAfterAStop) {
  SlidingValve valve(friction_from_s_j(5, 3));
  EXPECT_EQ(positions(valve, {5, 5, 8, 8.5, 9}), (std::vector<double>{4, 4, 4, 7.5, 8}));
}

TEST(SimulateSlidingValve, StickBandAndJumpOfEachStrokeAreSeen) {
  const Friction friction = friction_from_bands(6, 4, 1);
  SlidingValve valve(friction);
  valve.rest(0);
  std::vector<double> u;
  std::vector<double> x;
  for (int t = 0; t < 6000; ++t) {
    u.push_back(10 * std::sin(2 * std::numbers::pi * t / 2000.0));
    x.push_back(valve.step(u.back()));
  }
  // After one whole cycle: the turning points are at t = 2500 and 3500.
  double jump_down = 0;
  double travel_down = 0;
  for (int t = 2501; t < 3500; ++t) {
    if (x[t] != x[t - 1]) {
      travel_down = u[2500] - u[t];
      jump_down = x[t - 1] - x[t];
      break;
    }
  }
  double jump_up = 0;
  double travel_up = 0;
  for (int t = 3501; t < 4500; ++t) {
    if (x[t] != x[t - 1]) {
      travel_up = u[t] - u[3500];
      jump_up = x[t] - x[t - 1];
      break;
    }
  }
  constexpr double kOneSample = 0.04;  // largest step of u
  EXPECT_NEAR(travel_down, 4, kOneSample);
  EXPECT_NEAR(jump_down, 3, kOneSample);
  EXPECT_NEAR(travel_up, 6, kOneSample);
  EXPECT_NEAR(jump_up, 5, kOneSample);
}

TEST(SimulateCoastingValve, NeedsTheBandToTurnAndNothingToGoOn) {
  // S = 4, J = 2: fs = 3, fd = 1.
  CoastingValve valve(friction_from_s_j(4, 2));
  valve.rest(0);
  EXPECT_EQ(valve.step(3), 0);
  EXPECT_EQ(valve.step(3.5), 2.5);  // free: u - fd
  EXPECT_EQ(valve.step(3.4), 2.5);  // turns a little
  EXPECT_EQ(valve.step(3.6), 2.6);  // goes on without a jump
  EXPECT_EQ(valve.step(-0.4), 2.6);
  EXPECT_EQ(valve.step(-0.5), 0.5);  // more than S = 4 below the turning point
}

TEST(SimulateCoastingValve, AFreeStrokeFollowsTheSignal) {
  CoastingValve valve(friction_from_bands(5, 0, 0));  // sticks with rising u only
  valve.rest(0);
  EXPECT_EQ(valve.step(-1), -1);
  EXPECT_EQ(valve.step(-2), -2);
  EXPECT_EQ(valve.step(3), -2);
  EXPECT_EQ(valve.step(3.5), 3.5);
  EXPECT_EQ(valve.step(3), 3);
}

TEST(SimulateKanoValve, IsTheSlidingValveInOtherWords) {
  int moves = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random("kano", seed);
    const double band = random.uniform(0.5, 10);
    const double jump = band * random.uniform();
    KanoValve kano(band, jump);
    SlidingValve sliding(friction_from_s_j(band, jump));
    const std::vector<double> u = random_walk(seed, random.log_uniform(0.1, 5));
    const std::vector<double> a = positions(kano, u);
    const std::vector<double> b = positions(sliding, u);
    for (std::size_t t = 0; t < u.size(); ++t) {
      ASSERT_NEAR(a[t], b[t], 1e-9) << "seed " << seed << " sample " << t;
      if (t > 0 && a[t] != a[t - 1]) ++moves;
    }
  }
  EXPECT_GT(moves, 10000);
}

TEST(SimulateBacklashValve, LosesTheGapAtEveryReversal) {
  BacklashValve valve(2);
  EXPECT_EQ(positions(valve, {0.5, 1, 3, 2, 1, 0, -1}),
            (std::vector<double>{0, 0, 2, 2, 2, 1, 0}));
}

TEST(SimulateBacklashValve, IsTheSlidingValveWithoutJump) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const std::vector<double> u = random_walk(seed, 1);
    BacklashValve backlash(3);
    SlidingValve sliding(friction_from_s_j(3, 0));
    EXPECT_EQ(positions(backlash, u), positions(sliding, u)) << "seed " << seed;
  }
}

TEST(SimulateValves, StayWithinTheStickBandOfTheSignal) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Friction friction = friction_from_bands(6, 4, 1);
    const std::vector<double> u = random_walk(seed, 1);
    HeValve he(friction);
    SlidingValve sliding(friction);
    for (Valve* valve : {static_cast<Valve*>(&he), static_cast<Valve*>(&sliding)}) {
      const std::vector<double> x = positions(*valve, u);
      for (std::size_t t = 0; t < u.size(); ++t) {
        ASSERT_LE(u[t] - x[t], friction.static_ascending);
        ASSERT_GE(u[t] - x[t], -friction.static_descending);
      }
    }
  }
}

}  // namespace
}  // namespace workbench
