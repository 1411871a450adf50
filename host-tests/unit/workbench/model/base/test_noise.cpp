// Colours, whitening and the tests that decide.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "workbench/model/base/noise.hpp"

namespace workbench {
namespace {

std::vector<double> noise(std::size_t n, double pole, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> v(n);
  double last = 0;
  for (double& value : v) value = last = pole * last + normal(random);
  return v;
}

TEST(Noise, FindsTheColourOfAnAutoregression) {
  const NoiseColour colour = colour_of(noise(5000, 0.8, 1000));
  ASSERT_GE(colour.a.size(), 2u);
  EXPECT_NEAR(colour.a[1], -0.8, 0.03);
  EXPECT_NEAR(colour.variance, 1, 0.06);
  EXPECT_EQ(colour_of(noise(5000, 0, 1001)).a.size(), 1u);
}

TEST(Noise, TellsWhiteFromColoured) {
  int white = 0;
  for (std::uint64_t seed = 1000; seed < 1100; ++seed) {
    white += is_white(noise(1000, 0, seed));
    EXPECT_FALSE(is_white(noise(1000, 0.3, seed)));
  }
  EXPECT_GE(white, 95);
}

TEST(Noise, KnowsHowMuchOfAResidualItsPastPredicts) {
  EXPECT_LT(predictable_share(noise(3000, 0, 1000)), 0.02);
  EXPECT_NEAR(predictable_share(noise(3000, 0.8, 1000)), 0.64, 0.06);
  EXPECT_TRUE(is_noise(noise(3000, 0, 1000)));
  EXPECT_TRUE(is_noise(noise(3000, 0.2, 1000)));
  EXPECT_FALSE(is_noise(noise(3000, 0.7, 1000)));
}

// Two readings far off hide a wave that all others show.
TEST(Noise, AFewReadingsFarOffDoNotHideTheRest) {
  auto v = noise(1000, 0.8, 1000);
  EXPECT_EQ(without_glitches(v), v);
  v[300] = 200;
  v[600] = -200;
  EXPECT_LT(predictable_share(v), kPredictable);
  EXPECT_FALSE(is_noise(v));
  EXPECT_LT(without_glitches(v)[300], 20);
  EXPECT_EQ(without_glitches(v)[299], v[299]);
}

// A level that is missed by as much as the noise is no noise.
TEST(Noise, ALevelThatIsMissedIsNoNoise) {
  auto v = noise(1000, 0, 1000);
  EXPECT_TRUE(is_noise(v));
  for (double& value : v) value += 1;
  EXPECT_FALSE(is_noise(v));
}

TEST(Noise, FollowsUOnlyWhereItDoes) {
  const auto u = noise(2000, 0.7, 1000);
  auto e = noise(2000, 0.5, 2000);
  EXPECT_FALSE(follows_u(e, u));
  EXPECT_EQ(share_following_u(e, u), 0);
  for (std::size_t k = 3; k < e.size(); ++k) e[k] += 0.3 * u[k - 3];
  EXPECT_TRUE(follows_u(e, u));
}

TEST(Noise, KnowsByHowMuchAResidualFollowsU) {
  const auto u = noise(20000, 0, 1000);
  auto e = noise(20000, 0, 2000);
  for (std::size_t k = 3; k < e.size(); ++k) e[k] += 0.5 * u[k - 3];
  EXPECT_NEAR(share_following_u(e, u), 0.2, 0.02);
}

TEST(Noise, AResidualFollowsUByNoMoreThanAll) {
  std::vector<double> u;
  for (int k = 0; k < 1000; ++k)
    u.push_back(std::sin(0.25 * k) + 0.3 * std::sin(0.5 * k));
  std::vector<double> e(u.size());
  for (std::size_t k = 2; k < e.size(); ++k) e[k] = u[k - 2] * u[k - 2] + u[k - 1];
  const double share = share_following_u(e, u);
  EXPECT_GT(share, 0);
  EXPECT_LE(share, 1);
}

// The smaller model is right: what a search found on other samples has no slope here.
TEST(Noise, ADifferenceThatIsNotThereIsRarelySignificant) {
  int significant = 0;
  constexpr int kDraws = 200;
  const Blocks blocks(1000, 5);
  for (int i = 0; i < kDraws; ++i) {
    const auto seed = static_cast<std::uint64_t>(1000 + i);
    const auto small = noise(1000, 0.9, seed);
    auto large = small;
    const auto wrong = noise(1000, 0.95, seed + 5000);
    for (std::size_t k = 0; k < large.size(); ++k) large[k] -= 0.1 * wrong[k];
    significant += test_difference(small, large, blocks).p_value < 0.05;
  }
  EXPECT_LE(significant, 22);
}

TEST(Noise, ADifferenceThatIsThereHasSlopeOne) {
  const Blocks blocks(1000, 5);
  const auto large = noise(1000, 0.5, 1000);
  auto small = large;
  const auto missing = noise(1000, 0.9, 7);
  for (std::size_t k = 0; k < small.size(); ++k) small[k] += missing[k];
  const DifferenceTest test = test_difference(small, large, blocks);
  EXPECT_NEAR(test.slope, 1, 0.1);
  EXPECT_LT(test.p_value, 1e-10);
  const RatioInterval ratio = bootstrap_ratio(small, large, blocks, 5);
  EXPECT_LT(ratio.high, 1);
  EXPECT_GT(ratio.low, 0);
  EXPECT_LE(ratio.low, ratio.high);
}

// (W18) A slow load and a model of something else, on samples that judge.
TEST(Noise, SlowNoiseIsHardlyEverLikeASimulation) {
  constexpr std::size_t kSamples = 2000;
  constexpr int kDraws = 200;
  const Blocks blocks(kSamples, 20);
  int significant = 0;
  for (std::uint64_t seed = 1000; seed < 1000 + kDraws; ++seed) {
    const auto load = noise(kSamples, 0.98, seed);
    const auto wrong = noise(kSamples, 0.98, seed + 5000);
    auto large = load;
    for (std::size_t k = 0; k < large.size(); ++k) large[k] -= wrong[k];
    significant += likeness_by_chance(load, large, blocks) < 0.05;
  }
  EXPECT_LE(significant, kDraws / 10);
}

TEST(Noise, WhatLeavesLittleIsLikeTheResidual) {
  constexpr std::size_t kSamples = 2000;
  const Blocks blocks(kSamples, 20);
  const auto small = noise(kSamples, 0.95, 7);
  const auto left = [&](double share) {
    auto large = small;
    for (double& value : large) value *= share;
    return likeness_by_chance(small, large, blocks);
  };
  EXPECT_LT(left(0.1), 1e-6);
  EXPECT_LT(left(0.1), left(0.3));
  EXPECT_LT(left(0.3), left(0.9));
  EXPECT_EQ(left(1), 1);
  EXPECT_EQ(left(1.5), 1);
}

// A difference as large as simulated in all samples that judge, or many times as large in
// the last that do and absent in the others.
TEST(Noise, OneStretchAloneIsNoProof) {
  constexpr std::size_t kSamples = 2000;
  const Blocks blocks(kSamples, 5);
  std::size_t last = 0;
  for (const Block& block : blocks.blocks()) {
    if (!block.estimation) last = block.first;
  }
  const auto test_of = [&](bool everywhere) {
    auto small = noise(kSamples, 0, 1000);
    auto large = small;
    for (std::size_t k = 0; k < small.size(); ++k) {
      const double difference = k % 20 < 10 ? 0.3 : -0.3;
      const double share = everywhere ? 1.0 : k >= last ? 10.0 : 0.0;
      small[k] += share * difference;
      large[k] += (share - 1) * difference;
    }
    return test_difference(small, large, blocks);
  };
  EXPECT_LT(test_of(true).p_steady, 1e-4);
  EXPECT_LT(test_of(false).p_value, 0.5 * test_of(false).p_steady);
  EXPECT_GT(test_of(false).p_steady, 0.01);
}

TEST(Noise, KnowsTheNormalAndTheChiSquare) {
  EXPECT_NEAR(normal_tail(1.6449), 0.05, 1e-4);
  EXPECT_NEAR(normal_tail(0), 0.5, 1e-12);
  EXPECT_NEAR(chi_square_score(31.41, 20), 1.645, 0.02);
}

TEST(Noise, AutocorrelationOfAnAlternatingSignalAlternates) {
  std::vector<double> v(1000);
  for (std::size_t k = 0; k < v.size(); ++k) v[k] = k % 2 == 0 ? 1 : -1;
  const auto r = autocorrelation(v, 2);
  EXPECT_NEAR(r[0], -1, 0.01);
  EXPECT_NEAR(r[1], 1, 0.01);
}

}  // namespace
}  // namespace workbench
