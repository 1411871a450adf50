// Who holds a reading: the sensor, the historian, or nobody.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "support/workbench/historian.hpp"
#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/holds.hpp"

namespace workbench::effects {
namespace {

// A load that wanders, so that the readings never come back to the same value.
test::SetpointLoop wandering() {
  test::SetpointLoop loop;
  loop.load = [random = std::mt19937_64(5), at = 0.0](std::size_t) mutable {
    at += std::normal_distribution<double>(0, 0.15)(random);
    return at;
  };
  return loop;
}

std::function<double(double)> sticky_reading(double band) {
  return [band, reading = 0.0](double y) mutable {
    if (std::abs(y - reading) > band) reading = y;
    return reading;
  };
}

TEST(WhoHolds, ASensorWhoseJumpsTheControllerAnswers) {
  test::SetpointLoop loop = wandering();
  loop.sensor = sticky_reading(1.5);
  const Recording recording = test::simulated(loop);
  EXPECT_EQ(who_holds(recording.u, recording.y), Holder::kSensor);
}

TEST(WhoHolds, AHistorianWhoseHoldsTheControllerNeverSaw) {
  const Recording recording = test::simulated(wandering());
  const auto y = test::boxcar(recording.y, 1.5, 200);
  EXPECT_EQ(who_holds(recording.u, y), Holder::kHistorian);
  EXPECT_EQ(who_holds(test::boxcar(recording.u, 1, 200), y), Holder::kHistorian);
}

TEST(WhoHolds, EitherWhereUIsMovedByHand) {
  const Recording recording = test::simulated(wandering());
  const auto y = test::boxcar(recording.y, 1.5, 200);
  std::vector<double> u(y.size());
  for (std::size_t k = 0; k < u.size(); ++k) u[k] = k / 300 % 2 == 0 ? 40 : 60;
  EXPECT_EQ(who_holds(u, y), Holder::kEither);
}

TEST(WhoHolds, NobodyWhereYIsAsItWasOrCoarse) {
  const Recording recording = test::simulated(wandering());
  EXPECT_EQ(who_holds(recording.u, recording.y), Holder::kNobody);
  EXPECT_EQ(who_holds(recording.u, test::quantise(recording.y, 2)), Holder::kNobody);
  // A converter's steps in a file of two decimals are not all equal.
  std::vector<double> written = test::quantise(recording.y, 2.0 / 3);
  for (double& value : written) value = std::round(100 * value) / 100;
  EXPECT_EQ(who_holds(recording.u, written), Holder::kNobody);
}

TEST(HoldLike, StandsStillWhereTheReadingDoes) {
  const std::vector<double> reading = {1, 1, 2, 2, 2, 3};
  std::vector<double> signal = {10, 11, 12, 13, 14, 15};
  hold_like(reading, same_reading(1, 3), signal);
  EXPECT_EQ(signal, (std::vector<double>{10, 10, 12, 12, 12, 15}));
  const Held held = held_in(reading, same_reading(1, 3));
  EXPECT_EQ(held.jumps, 2u);
  EXPECT_DOUBLE_EQ(held.least_jump, 1);
}

// y with noise of 0.2 and five digits behind the point, u in steps.
struct Signals {
  std::vector<double> u;
  std::vector<double> y;
};
Signals noisy() {
  Signals out;
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal(0, 0.2);
  double z = 0;
  for (std::size_t k = 0; k < 700; ++k) {
    out.u.push_back(k / 90 % 2 == 0 ? 45 : 55);
    z += (out.u.back() - 50 - z) / 20;
    out.y.push_back(std::round(1e5 * (50 + z + normal(random))) / 1e5);
  }
  return out;
}

void hold(std::vector<double>& signal, std::size_t first, std::size_t last) {
  std::fill(signal.begin() + static_cast<std::ptrdiff_t>(first),
            signal.begin() + static_cast<std::ptrdiff_t>(last), signal[first]);
}

TEST(ScannedSlowly, IsWhatComesOnceOrTwice) {
  std::vector<double> scanned;
  std::vector<double> sticks;
  for (int k = 0; k < 200; ++k) {
    const double y = std::sin(0.05 * k);
    scanned.push_back(std::sin(0.05 * (k - k % 2)));
    if (sticks.empty() || std::abs(y - sticks.back()) > 0.06)
      sticks.push_back(y);
    else
      sticks.push_back(sticks.back());
  }
  EXPECT_TRUE(is_scanned_slowly(scanned, 0, 2));
  EXPECT_FALSE(is_scanned_slowly(sticks, 0, 2));
}

TEST(FrozenIn, FindsTheStretchesInWhichANoisyReadingStandsStill) {
  Signals s = noisy();
  EXPECT_EQ(frozen_in(s.u, s.y).least, 0u);
  hold(s.y, 130, 300);
  hold(s.y, 500, 520);
  const Frozen found = frozen_in(s.u, s.y);
  EXPECT_EQ(found.stretches, 2u);
  EXPECT_EQ(found.samples, 190u);
  EXPECT_EQ(found.least, 20u);
  EXPECT_EQ(found.first, 130u);
  EXPECT_EQ(found.longest, 170u);
}

TEST(FrozenIn, LeavesOutWhatStandsStillForOtherReasons) {
  Signals short_one = noisy();
  hold(short_one.y, 130, 141);
  EXPECT_EQ(frozen_in(short_one.u, short_one.y).least, 0u);
  Signals begins = noisy();
  hold(begins.y, 0, 100);
  EXPECT_EQ(frozen_in(begins.u, begins.y).least, 0u);
  Signals at_limit = noisy();  // the end of the range of the transmitter
  for (double& y : at_limit.y) y = std::min(y, 53.0);
  EXPECT_EQ(frozen_in(at_limit.u, at_limit.y).least, 0u);
  Signals coarse = noisy();
  for (double& y : coarse.y) y = std::round(2 * y) / 2;
  hold(coarse.y, 130, 300);
  EXPECT_EQ(frozen_in(coarse.u, coarse.y).least, 0u);
  Signals both = noisy();  // the recorder held u, too
  std::mt19937_64 random(8);
  for (double& u : both.u) u += std::normal_distribution<double>(0, 0.1)(random);
  hold(both.y, 130, 300);
  EXPECT_GT(frozen_in(both.u, both.y).least, 0u);
  hold(both.u, 130, 300);
  EXPECT_EQ(frozen_in(both.u, both.y).least, 0u);
}

TEST(FrozenIn, AtTheEndOfTheRangeIsAReadingThatLeavesItByAJump) {
  Signals s = noisy();
  s.y[160] = 57;
  hold(s.y, 160, 260);
  s.y[260] = 46;
  EXPECT_EQ(frozen_in(s.u, s.y).longest, 100u);
}

TEST(FrozenIn, IsNotWhatComesToRest) {
  Signals s;
  double z = 0;
  for (std::size_t k = 0; k < 700; ++k) {
    s.u.push_back(k < 200 ? 50 + 8 * std::sin(0.3 * static_cast<double>(k)) : 55);
    z += (s.u.back() - 50 - z) / 5;
    s.y.push_back(std::round(1e5 * z) / 1e5);
  }
  s.y[699] += 1;  // the value at rest is not the largest
  EXPECT_EQ(frozen_in(s.u, s.y).least, 0u);
}

}  // namespace
}  // namespace workbench::effects
