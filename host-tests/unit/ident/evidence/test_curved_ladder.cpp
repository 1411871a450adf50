// What a stem tells beside a bent characteristic and a setpoint, of valves that stick and
// of valves that do not.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "ident/evidence/curved_ladder.hpp"
#include "support/ident/problems.hpp"

namespace ident {
namespace {

struct SteppedLoop {
  std::vector<double> u, y, sp;
};

constexpr double kStepSwing = 8;

// A lag behind a valve and a characteristic, under a load, while u is moved a few times.
template <class Valve>
SteppedLoop stepped(
    Valve valve, double (*trim)(double) = [](double x) { return x; }) {
  test::Random random(5);
  SteppedLoop out;
  double u = 0;
  double wanted = 0;
  double stem = 0;
  double state = 0;
  double load = 0;
  for (int t = 0; t < 1200; ++t) {
    if (t % 200 == 100) wanted = (t / 200) % 2 == 0 ? kStepSwing / 2 : -kStepSwing / 2;
    u += 0.04 * (wanted - u) + 0.02 * test::normal(random);
    state += 0.3 * (trim(stem) - state);
    stem = valve(u);
    load = 0.98 * load + 0.02 * test::normal(random);
    out.u.push_back(u);
    out.sp.push_back(wanted);
    out.y.push_back(state + load + 0.02 * test::normal(random));
  }
  return out;
}

StickSlipValve<double> stuck_stem(SlipMotion motion) {
  return {{0.8, 1.2, 1.2, motion}, 0.0};
}

SteppedLoop stuck_in_steps(SlipMotion motion = SlipMotion::kSlides) {
  return stepped([v = stuck_stem(motion)](double u) mutable { return v.step(u); });
}

// Whatever it lets through grows with the square of its travel.
SteppedLoop bent_in_steps() {
  return stepped([](double u) { return u; }, [](double x) { return x + 0.08 * x * x; });
}

struct CurvedNats {
  bool known = false;
  double nats = 0;
  double narrower = 0;
  double wider = 0;
  double of_curve = 0;
};

CurvedNats nats_of(const SteppedLoop& loop, bool setpoint = true, int budget = 1000000,
                   const FittedStem<double>& fitted = {}) {
  std::vector<double> y = loop.y;
  double mean = 0;
  for (const double v : y) mean += v / static_cast<double>(y.size());
  for (double& v : y) v -= mean;
  std::vector<double> scratch(y.size());
  OneStepSums<double> sums;
  CurvedLadder<double> ladder;
  ladder.start({loop.u, y, scratch, &sums, 400, kStepSwing, kStepSwing},
               setpoint ? std::span<const double>(loop.sp) : std::span<const double>(),
               fitted);
  while (!ladder.step(budget)) {
  }
  return {ladder.known(), ladder.nats(), ladder.narrower_band(), ladder.wider_band(),
          ladder.curve_nats()};
}

TEST(CurvedLadder, KnowsAStemThatSlides) {
  const CurvedNats found = nats_of(stuck_in_steps());
  EXPECT_GT(found.nats, 50);
  EXPECT_NEAR(found.narrower, 2, 0.3);
  EXPECT_NEAR(found.wider, 2, 0.3);
}

TEST(CurvedLadder, KnowsAStemThatSticksAgain) {
  const CurvedNats found = nats_of(stuck_in_steps(SlipMotion::kResticks));
  EXPECT_GT(found.nats, 30);
  EXPECT_NEAR(found.narrower, 2, 0.3);
}

TEST(CurvedLadder, WeighsTheFittedStemToo) {
  const SteppedLoop loop = stuck_in_steps();
  const StickSlipValve<double> true_stem = stuck_stem(SlipMotion::kSlides);
  const auto with = [&](int parameters) {
    return nats_of(loop, true, 1000000, {true_stem, 2, parameters});
  };
  EXPECT_GT(with(1).nats, nats_of(loop).nats + 3) << "no rung is the true band";
  EXPECT_EQ(with(1).narrower, 2);
  EXPECT_EQ(with(1).wider, 2);
  EXPECT_NEAR(with(1).nats - with(2).nats, std::log(1140) / 2, 0.1);
}

TEST(CurvedLadder, SaysNothingOfAStemThatFollows) {
  EXPECT_LT(nats_of(stepped([](double u) { return u; })).nats, 5);
}

TEST(CurvedLadder, TakesNoBentCharacteristicForAStem) {
  EXPECT_LT(nats_of(bent_in_steps()).nats, 5);
}

TEST(CurvedLadder, WeighsTheCharacteristicItself) {
  EXPECT_GT(nats_of(bent_in_steps()).of_curve, 100);
  EXPECT_LT(nats_of(bent_in_steps()).of_curve, nats_of(bent_in_steps(), false).of_curve);
  EXPECT_LT(nats_of(stepped([](double u) { return u; })).of_curve, -20)
      << "twelve lags cost 42 nats";
}

TEST(CurvedLadder, TakesTheSmallerNumberWhereTheSetpointMoves) {
  EXPECT_LT(nats_of(stuck_in_steps()).nats, nats_of(stuck_in_steps(), false).nats);
}

TEST(CurvedLadder, IsTheSameInPieces) {
  EXPECT_EQ(nats_of(stuck_in_steps(), true, 1).nats, nats_of(stuck_in_steps()).nats);
}

TEST(CurvedLadder, KnowsNothingOfAWindowTooShort) {
  SteppedLoop loop = stuck_in_steps();
  for (std::vector<double>* signal : {&loop.u, &loop.y, &loop.sp}) signal->resize(65);
  EXPECT_FALSE(nats_of(loop).known);
  EXPECT_TRUE(nats_of(stuck_in_steps()).known);
}

}  // namespace
}  // namespace ident
