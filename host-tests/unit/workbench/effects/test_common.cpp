// What several effects share: friction and the curve.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

#include "workbench/effects/common.hpp"

namespace workbench::effects {
namespace {

std::vector<double> moved(const StemFriction& friction, std::vector<double> u,
                          std::size_t* at_rest = nullptr) {
  ValveSignal signal{1, u, 0};
  move_with_friction(friction, signal);
  if (at_rest != nullptr) *at_rest = signal.at_rest;
  return u;
}

TEST(StemFriction, NoneIsAStemThatFollows) {
  const std::vector<double> u = {0, 3, 1, -2, 5};
  EXPECT_EQ(moved({}, u), u);
}

TEST(StemFriction, BacklashLosesItsWidthAtEachReversal) {
  const std::vector<double> u = {0, 1, 2, 3, 2, 1, 0, 1, 2};
  EXPECT_EQ(moved({2, 0, 0, 0}, u), (std::vector<double>{0, 0, 1, 2, 2, 2, 1, 1, 1}));
}

TEST(StemFriction, ASlipTakesTheStemToTheSignalAtOnceAndItHoldsAgain) {
  std::size_t at_rest = 0;
  const std::vector<double> u = {0, 1, 2, 3, 4, 5, 6, 7};
  EXPECT_EQ(moved({0, 2.5, 2.5, 0}, u, &at_rest),
            (std::vector<double>{0, 0, 0, 3, 3, 3, 6, 6}));
  EXPECT_EQ(at_rest, 3u);
}

TEST(StemFriction, ASlowSlipApproachesExponentially) {
  const std::vector<double> u = {0, 4, 4, 4};
  const auto x = moved({0, 2, 2, 3}, u);
  const double left = std::exp(-1.0 / 3);
  EXPECT_NEAR(x[1], 4 - 4 * 3 * (1 - left), 1e-12);
  EXPECT_NEAR(x[2], 4 - 4 * left * 3 * (1 - left), 1e-12);
}

TEST(StemFriction, StrokesStickApart) {
  const std::vector<double> u = {0, 2, 4, 2, 0, -2, -4};
  EXPECT_EQ(moved({0, 0, 5, 0}, u), (std::vector<double>{0, 2, 4, 4, 4, -2, -4 + 2}));
}

// On and off are reached from one side each, whatever the gap is.
TEST(ReversalsBeyond, OfASwitchShowNoStem) {
  std::vector<double> u(200);
  for (std::size_t k = 0; k < u.size(); ++k) u[k] = k / 20 % 2 == 0 ? 0 : 100;
  const auto seen = [&u] {
    return reversals_beyond(situation_of(u, u, 1), 10, "reversals");
  };
  EXPECT_FALSE(seen().acted);
  EXPECT_EQ(seen().events, 0);
  for (std::size_t k = 0; k + 1 < u.size(); k += 4) u[k] = u[k + 1] = 50;
  EXPECT_TRUE(seen().acted);
  EXPECT_GT(seen().events, 50);
}

TEST(LagStarts, ReachFromBelowASampleToBeyondTheFirstLag) {
  const std::vector<double> u(1000, 0.0);
  Situation s = situation_of(u, u, 1);
  s.first_lag_s = 30;
  const auto starts = lag_starts(s);
  EXPECT_LE(starts.front()[0], 0.5);
  EXPECT_GE(starts.back()[0], 60);
}

// What swings through noise of its own for some cycles, and a load that never loses step.
TEST(SwingByChance, TellsALineFromNoiseThatSwings) {
  constexpr std::size_t kSamples = 2000;
  constexpr double kPeriod = 40;
  const double angle = 2 * std::numbers::pi / kPeriod;
  int band = 0;
  int line = 0;
  for (std::uint64_t seed = 1000; seed < 1040; ++seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    // Loses step in some three cycles.
    constexpr double kRadius = 0.99;
    std::vector<double> swing(2 * kSamples, 0.0);
    for (std::size_t k = 2; k < swing.size(); ++k) {
      swing[k] = 2 * kRadius * std::cos(angle) * swing[k - 1] -
                 kRadius * kRadius * swing[k - 2] + normal(random);
    }
    swing.erase(swing.begin(), swing.begin() + kSamples);
    const auto p_of = [&](const std::vector<double>& signal) {
      std::complex<double> sum(0, 0);
      for (std::size_t k = 0; k < kSamples; ++k) {
        sum += signal[k] * std::polar(2.0 / kSamples, angle * static_cast<double>(k));
      }
      std::vector<double> load(kSamples);
      std::vector<double> residual(kSamples);
      for (std::size_t k = 0; k < kSamples; ++k) {
        const double at = angle * static_cast<double>(k);
        load[k] = sum.real() * std::cos(at) + sum.imag() * std::sin(at);
        residual[k] = signal[k] - load[k];
      }
      return swing_by_chance(residual, load, kPeriod);
    };
    band += p_of(swing) < 0.01;
    std::vector<double> steady(kSamples);
    for (std::size_t k = 0; k < kSamples; ++k) {
      steady[k] = std::sin(angle * static_cast<double>(k)) + 2 * normal(random);
    }
    line += p_of(steady) < 0.01;
  }
  EXPECT_LE(band, 1);
  EXPECT_GE(line, 39);
}

}  // namespace
}  // namespace workbench::effects
