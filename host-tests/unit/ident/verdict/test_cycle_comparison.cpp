// The counts and ratios of residuals, worked by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "ident/verdict/cycle_comparison.hpp"
#include "support/ident/problems.hpp"

namespace ident {
namespace {

using Signal = std::vector<double>;

// An AR(1) residual, and a simulation that is zero.
Signal coloured(std::size_t n, double pole, std::uint64_t seed) {
  test::Random random(seed);
  Signal e{test::normal(random)};
  while (e.size() < n) {
    e.push_back(pole * e.back() + test::normal(random));
  }
  return e;
}

double observations(const Signal& e, double period) {
  return independent_observations<double>(e, Signal(e.size(), 0), period);
}

TEST(IndependentObservations, CountsAllOfWhiteNoise) {
  EXPECT_NEAR(observations(coloured(4000, 0, 1), 50), 4000, 300);
}

// (1 − 2ρ·cos ω + ρ²)/(1 − ρ²) with ρ = 0.8 and a period of four samples: 1.64/0.36 > 1;
// with a period without end: 0.04/0.36 = 1/9.
TEST(IndependentObservations, LooksAtThePeriod) {
  const Signal e = coloured(20000, 0.8, 2);
  EXPECT_EQ(observations(e, 4), 20000);
  EXPECT_NEAR(observations(e, 1e6) / 20000, 1.0 / 9, 0.01);
  EXPECT_LT(observations(e, 100), observations(e, 30));
}

TEST(IndependentObservations, TakesOnlyTheResidual) {
  const Signal e = coloured(500, 0.5, 3);
  Signal y(500), simulated(500);
  for (std::size_t t = 0; t < y.size(); ++t) {
    simulated[t] = 10 * std::sin(0.1 * static_cast<double>(t));
    y[t] = simulated[t] + e[t];
  }
  EXPECT_NEAR(independent_observations<double>(y, simulated, 60), observations(e, 60),
              1e-6);
}

TEST(IndependentObservations, BearsAPerfectSimulation) {
  EXPECT_EQ(observations(Signal(100, 0), 20), 100);
}

CycleGain<double> compare(const Signal& y, double period, const Signal& reference,
                          const Signal& candidate) {
  CycleComparison<double> comparison(y, period);
  comparison.add(reference, 1);
  comparison.add(candidate, -1);
  return comparison.gain();
}

// Five stretches of two samples; the reference is off by 1, 2, 1, 1, 0 in each sample of
// them, the candidate by 0, 1, 0, 0, 1: gains 2, 6, 2, 2, −2, mean 2, variance 8.
TEST(CycleComparison, CountsAndWeighsTheStretches) {
  const Signal y(10, 0);
  const auto gain =
      compare(y, 2, {1, 1, 2, 2, 1, 1, 1, 1, 0, 0}, {0, 0, 1, 1, 0, 0, 0, 0, 1, 1});
  EXPECT_EQ(gain.cycles, 5);
  EXPECT_EQ(gain.better, 4);
  EXPECT_NEAR(gain.consistency, 2 / std::sqrt(8.0 / 5), 1e-12);
}

TEST(CycleComparison, TurnsItsSignWithTheModels) {
  const Signal y = coloured(400, 0.3, 4);
  const Signal one = coloured(400, 0.9, 5);
  const Signal other(400, 0);
  const auto gain = compare(y, 40, one, other);
  const auto back = compare(y, 40, other, one);
  EXPECT_EQ(gain.cycles, 10);
  EXPECT_EQ(gain.better + back.better, 10);
  EXPECT_NEAR(gain.consistency, -back.consistency, 1e-12);
}

TEST(CycleComparison, TakesFourToFortyEightStretches) {
  const Signal y(1000, 0);
  EXPECT_EQ(compare(y, 900, y, y).cycles, CycleComparison<double>::kFewest);
  EXPECT_EQ(compare(y, 100, y, y).cycles, 10);
  EXPECT_EQ(compare(y, 2, y, y).cycles, CycleComparison<double>::kMost);
}

TEST(CycleComparison, SeesNothingInTheSameModelTwice) {
  const Signal y(200, 3);
  const auto gain = compare(y, 20, Signal(200, 1), Signal(200, 1));
  EXPECT_EQ(gain.better, 0);
  EXPECT_EQ(gain.consistency, 0);
}

TEST(CycleComparison, IsTheSameInFloat) {
  const std::vector<float> y(8, 0.0f);
  CycleComparison<float> comparison(y, 2.0f);
  comparison.add(std::vector<float>{1, 1, 2, 2, 1, 1, 1, 1}, 1);
  comparison.add(y, -1);
  const auto gain = comparison.gain();
  EXPECT_EQ(gain.better, 4);
  // 2, 8, 2, 2: mean 3.5, variance 9.
  EXPECT_NEAR(gain.consistency, 3.5f / 1.5f, 1e-5f);
}

}  // namespace
}  // namespace ident
