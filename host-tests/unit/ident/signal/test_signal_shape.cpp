// Resolution, limits and shape of signals made by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "ident/signal/signal_shape.hpp"
#include "support/ident/all_at_once.hpp"
#include "support/ident/problems.hpp"

namespace ident {
namespace {

using Signal = std::vector<double>;

Signal sine(std::size_t n, double period) {
  Signal values;
  for (std::size_t t = 0; t < n; ++t) {
    values.push_back(std::sin(6.283185307179586 * static_cast<double>(t) / period));
  }
  return values;
}

Signal shape_noise(std::size_t n, std::uint64_t seed) {
  test::Random random(seed);
  Signal values(n);
  std::generate(values.begin(), values.end(), [&] { return test::normal(random); });
  return values;
}

Signal rounded(Signal values, double step) {
  for (double& value : values) {
    value = step * std::round(value / step);
  }
  return values;
}

double step_of(Signal values) {
  return test::level_step<double>(values);
}

TEST(LevelStep, FindsTheStepOfRounding) {
  for (const double step : {0.1, 0.37, 1.0}) {
    EXPECT_NEAR(step_of(rounded(shape_noise(2000, 1), step)), step, 1e-9) << step;
    EXPECT_NEAR(step_of(rounded(sine(800, 57.3), step)), step, 1e-9) << step;
  }
}

TEST(LevelStep, KnowsNeitherOffsetNorScale) {
  Signal values = rounded(sine(800, 57.3), 0.1);
  for (double& value : values) {
    value = 40.95 * value + 1e4;
  }
  EXPECT_NEAR(step_of(values), 4.095, 1e-6);
}

TEST(LevelStep, FindsTheStepThoughNoTwoNeighboursAreOneApart) {
  Signal values;
  for (int k = 0; k < 100; ++k) {
    values.insert(values.end(), {0, 2, 6, 7});
  }
  EXPECT_EQ(step_of(values), 1);
}

TEST(LevelStep, SeesNoneInAContinuum) {
  EXPECT_EQ(step_of(shape_noise(2000, 2)), 0);
  EXPECT_EQ(step_of(shape_noise(60, 3)), 0);
  EXPECT_EQ(step_of(sine(777, 57.3)), 0);
}

TEST(LevelStep, SeesNoneInAFineLattice) {
  EXPECT_EQ(step_of(rounded(shape_noise(4000, 4), 0.01)), 0);
}

TEST(LevelStep, SeesNoneInLevelsThatAreNoLattice) {
  Signal values;
  for (int k = 0; k < 100; ++k) {
    values.insert(values.end(), {0, 1, 2.4});
  }
  EXPECT_EQ(step_of(values), 0);
}

TEST(LevelStep, BearsNothingAndConstants) {
  EXPECT_EQ(step_of({}), 0);
  EXPECT_EQ(step_of({3}), 0);
  EXPECT_EQ(step_of(Signal(100, 3)), 0);
}

TEST(ShareAtLimits, CountsRests) {
  EXPECT_EQ(share_at_limits<double>(Signal{0, 0, 0.5, 1, 1, 1, 0.5, 0.2, 0.3, 0.4}), 0.5);
  // One sample at an extreme is a turning point.
  EXPECT_EQ(share_at_limits<double>(Signal{0, 0.5, 1, 0.5, 0, 0.5, 1, 0.5}), 0);
  // A rest may last to the end.
  EXPECT_EQ(share_at_limits<double>(Signal{0, 0.5, 1, 1}), 0.5);
  // Anywhere else a rest is none.
  EXPECT_EQ(share_at_limits<double>(Signal{0, 0.5, 0.5, 0.5, 1}), 0);
}

TEST(ShareAtLimits, SeesTheLimitOfAWave) {
  Signal values = sine(1000, 100);
  for (double& value : values) {
    value = std::min(value, 0.5);
  }
  // Above half its size for a third of the time.
  EXPECT_NEAR(share_at_limits<double>(values), 1.0 / 3, 0.02);
  EXPECT_EQ(share_at_limits<double>(sine(999, 57.3)), 0);
}

// Steps by hand rest at every level, a loop at its limits nowhere else.
TEST(ShareAtLimits, DoesNotTakeAStepTestForALimit) {
  const auto levels = [](std::initializer_list<double> of, std::size_t each) {
    Signal out;
    for (const double level : of) out.insert(out.end(), each, level);
    return out;
  };
  EXPECT_EQ(share_at_limits<double>(levels({0.5, 1, 0.5, 0, 0.5}, 20)), 0);
  // A controller output that is stored every fifth sample.
  EXPECT_NEAR(share_at_limits<double>(levels({0, 0.3, 0.6, 1, 1, 1, 1, 0.5}, 5)), 5.0 / 8,
              0.01);
}

TEST(ShareAtLimits, BearsNothingAndConstants) {
  EXPECT_EQ(share_at_limits<double>(Signal{}), 0);
  EXPECT_EQ(share_at_limits<double>(Signal(10, 2)), 1);
}

// A loop whose gain is just too high touches its limit once a cycle.
TEST(ShareOfTouches, SeesTheSameExtremeInMostCycles) {
  Signal values = sine(1000, 19.7);
  EXPECT_EQ(share_of_touches<double>(values, 1000 / 19.7), 0);
  for (double& value : values) {
    value = std::min(value, 0.95);
  }
  EXPECT_NEAR(share_of_touches<double>(values, 1000 / 19.7), 0.1, 0.02);
  EXPECT_EQ(share_of_touches<double>(Signal{0, 1, 0, 1, 0, 1, 0, 1}, 4), 0);  // too few
  EXPECT_EQ(share_of_touches<double>(Signal{}, 4), 0);
}

TEST(MovesRarely, KnowsAStepTest) {
  std::vector<double> steps;
  for (int t = 0; t < 600; ++t) steps.push_back(t / 100 % 3);
  EXPECT_TRUE(moves_rarely<double>(steps));
  EXPECT_TRUE(moves_rarely<double>({}));
}

TEST(MovesRarely, KnowsAControllerThatWaitsBetweenMoves) {
  std::vector<double> slow;
  for (int t = 0; t < 600; ++t) slow.push_back(std::sin(t / 10 / 7.0));
  EXPECT_FALSE(moves_rarely<double>(slow));
}

TEST(Kurtosis, TellsConstantSizeFromChance) {
  EXPECT_NEAR(kurtosis<double>(Signal{-1, 1, -1, 1}), 1, 1e-12);
  EXPECT_NEAR(kurtosis<double>(sine(1000, 50)), 1.5, 1e-9);
  EXPECT_NEAR(kurtosis<double>(shape_noise(20000, 5)), 3, 0.15);
}

TEST(Kurtosis, KnowsNeitherOffsetNorScale) {
  Signal values = shape_noise(100, 6);
  const double plain = kurtosis<double>(values);
  for (double& value : values) {
    value = 7 - 30 * value;
  }
  EXPECT_NEAR(kurtosis<double>(values), plain, 1e-9);
}

TEST(Kurtosis, BearsNothingAndConstants) {
  EXPECT_EQ(kurtosis<double>(Signal{}), 0);
  EXPECT_EQ(kurtosis<double>(Signal(10, 2)), 0);
}

TEST(SignalShape, IsTheSameInFloat) {
  std::vector<float> values = test::as<float>(rounded(sine(800, 57.3), 0.1));
  EXPECT_NEAR(kurtosis<float>(values), 1.5f, 0.01f);
  EXPECT_NEAR(test::level_step<float>(values), 0.1f, 1e-5f);
  EXPECT_EQ(share_at_limits<float>(std::vector<float>{0, 0, 1, 0.5f}), 0.5f);
}

}  // namespace
}  // namespace ident
