// Signals of which a known part was stored.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "ident/signal/storage.hpp"
#include "support/ident/problems.hpp"

namespace ident {
namespace {

using Signal = std::vector<double>;

Signal stored_wave(std::size_t n, double noise, std::uint64_t seed = 1) {
  test::Random random(seed);
  Signal x;
  for (std::size_t t = 0; t < n; ++t) {
    x.push_back(std::sin(0.05 * static_cast<double>(t)) + noise * test::normal(random));
  }
  return x;
}

Signal stored_rounded(Signal x, double step) {
  for (double& v : x) v = step * std::round(v / step);
  return x;
}

// Every `apart`-th sample stored, lines between them.
Signal lines(Signal x, std::size_t apart) {
  for (std::size_t t = 0; t + apart < x.size(); t += apart) {
    for (std::size_t k = 1; k < apart; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(apart);
      x[t + k] = x[t] + share * (x[t + apart] - x[t]);
    }
  }
  return x;
}

// Stored where it is further than `width` from what was stored before.
Signal exceptions(Signal x, double width) {
  double stored = x[0];
  for (double& v : x) {
    if (std::abs(v - stored) > width) stored = v;
    v = stored;
  }
  return x;
}

TEST(StoredSignal, LinesBetweenStoredPointsAreSeen) {
  for (const double noise : {0.0, 0.1, 1.0}) {
    const auto s = find_storage(lines(stored_wave(600, noise), 8));
    EXPECT_EQ(s.storage, Storage::kInterpolated) << noise;
    EXPECT_NEAR(s.interpolated, 7.0 / 8, 0.05) << noise;
    EXPECT_NEAR(s.points_apart, 8, 1.5) << noise;
  }
}

TEST(StoredSignal, RoundedLinesAreSeenToo) {
  const auto s = find_storage(stored_rounded(lines(stored_wave(600, 0.3), 8), 1e-3));
  EXPECT_EQ(s.storage, Storage::kInterpolated);
}

TEST(StoredSignal, WhatWasMeasuredHasNoLines) {
  for (const double noise : {0.003, 0.1, 1.0}) {
    for (std::uint64_t seed = 1; seed < 10; ++seed) {
      const auto s = find_storage(stored_wave(600, noise, seed));
      EXPECT_EQ(s.storage, Storage::kEverySample) << noise;
      EXPECT_LT(s.interpolated, 0.02) << noise;
      EXPECT_EQ(s.points_apart, 1) << noise;
    }
  }
}

// A smooth stored_wave bends everywhere, if little.
TEST(StoredSignal, ASmoothWaveHasNoLines) {
  EXPECT_EQ(find_storage(stored_wave(600, 0)).storage, Storage::kEverySample);
}

TEST(StoredSignal, ExceptionReportingHoldsAndQuantisationDoesNot) {
  const Signal x = stored_wave(600, 0.1);
  const auto held = find_storage(exceptions(x, 0.3));
  EXPECT_EQ(held.storage, Storage::kHeld);
  EXPECT_GT(held.held, 0.5);
  EXPECT_NEAR(held.points_apart, 1 / (1 - held.held), 0.5);
  // Each change of a smooth signal is just above the width, and so nearly one step.
  EXPECT_EQ(find_storage(exceptions(stored_wave(600, 0), 0.3)).storage, Storage::kHeld);
  const auto coarse = find_storage(stored_rounded(x, 0.5));
  EXPECT_GT(coarse.held, 0.5);
  EXPECT_EQ(coarse.storage, Storage::kEverySample);
}

// As written to a file with three decimals.
TEST(StoredSignal, HeldValuesOfManyDigitsAreNotCoarse) {
  Signal x = stored_wave(600, 0.1);
  for (std::size_t t = 0; t < x.size(); ++t) x[t] = x[t - t % 3];
  const auto s = find_storage(stored_rounded(x, 1e-3));
  EXPECT_EQ(s.storage, Storage::kHeld);
  EXPECT_NEAR(s.points_apart, 3, 0.1);
}

// A loop that comes to rest, and the steps of an operator.
TEST(StoredSignal, RestAndAFewStepsAreNotHeldByAHistorian) {
  Signal x = stored_wave(600, 0.1);
  for (std::size_t t = 200; t < x.size(); ++t) x[t] = x[200];
  EXPECT_EQ(find_storage(x).storage, Storage::kEverySample);
  Signal steps;
  for (int t = 0; t < 600; ++t) steps.push_back(std::sqrt(1.0 + t / 60));
  EXPECT_EQ(find_storage(steps).storage, Storage::kEverySample);
}

TEST(StoredSignal, StraightUIsBelievedOnlyBesideAMovingY) {
  const auto straight = find_storage(lines(stored_wave(600, 0.1), 8));
  const auto moving = find_storage(stored_wave(600, 0.1));
  const auto resting = find_storage(exceptions(stored_wave(600, 0.1), 0.3));
  EXPECT_TRUE(was_compressed(straight, moving));
  EXPECT_TRUE(was_compressed(moving, straight));
  EXPECT_FALSE(was_compressed(straight, resting));
  EXPECT_FALSE(was_compressed(moving, moving));
}

TEST(StoredSignal, OffsetScaleAndPrecisionDoNotMatter) {
  Signal x = lines(stored_wave(600, 0.3), 8);
  for (double& v : x) v = 50 - 3 * v;
  const auto s = find_storage(test::as<double>(test::as<float>(x)));
  EXPECT_EQ(s.storage, Storage::kInterpolated);
  EXPECT_NEAR(s.interpolated, 7.0 / 8, 0.05);
  Signal y = exceptions(stored_wave(600, 0.1), 0.3);
  for (double& v : y) v = 50 - 3 * v;
  EXPECT_EQ(find_storage(test::as<double>(test::as<float>(y))).storage, Storage::kHeld);
}

TEST(StoredSignal, TooShortOrConstantSignalsSayNothing) {
  EXPECT_EQ(find_storage(Signal{}).storage, Storage::kEverySample);
  EXPECT_EQ(find_storage(Signal(10, 1.0)).storage, Storage::kEverySample);
  const auto constant = find_storage(Signal(200, 1.0));
  EXPECT_EQ(constant.storage, Storage::kEverySample);
  EXPECT_EQ(constant.points_apart, 1);
}

}  // namespace
}  // namespace ident
