#include <gtest/gtest.h>

#include "ident/evidence/lag_bins.hpp"

namespace ident {
namespace {

class LagBins : public testing::TestWithParam<std::span<const LagBin>> {};

TEST_P(LagBins, FollowEachOtherWithoutAGap) {
  EXPECT_EQ(GetParam().front().first, 1);
  for (std::size_t b = 0; b < GetParam().size(); ++b) {
    EXPECT_LE(GetParam()[b].first, GetParam()[b].last);
    if (b > 0) {
      EXPECT_EQ(GetParam()[b].first, GetParam()[b - 1].last + 1);
    }
  }
}

TEST_P(LagBins, GrowWithTheirAge) {
  int width = 1;
  for (const LagBin& bin : GetParam()) {
    EXPECT_GE(bin.last - bin.first + 1, width);
    width = bin.last - bin.first + 1;
  }
}

TEST_P(LagBins, ReachHalfACycleBack) {
  EXPECT_EQ(GetParam().back().last, kEvidencePerCycle / 2);
}

INSTANTIATE_TEST_SUITE_P(CoarseAndFine, LagBins,
                         testing::Values(std::span<const LagBin>(kCoarseLagBins),
                                         std::span<const LagBin>(kFineLagBins)));

// Of a window of so many samples, an eighth is the past of its first prediction.
TEST(LagBinsFor, AreAsManyAsTheWindowBears) {
  const auto coarse = [](std::size_t samples) {
    return lag_bins_for(samples, kCoarseLagBins).size();
  };
  EXPECT_EQ(coarse(2048), 12u);
  EXPECT_EQ(coarse(472), 12u);  // 8 · 60 − 8
  EXPECT_EQ(coarse(471), 11u);
  EXPECT_EQ(coarse(264), 11u);  // 8 · 34 − 8
  EXPECT_EQ(coarse(263), 10u);
  EXPECT_EQ(coarse(168), 10u);
  EXPECT_EQ(coarse(112), 9u);
  EXPECT_EQ(coarse(111), 8u);
  EXPECT_EQ(coarse(80), 8u);
  EXPECT_EQ(coarse(56), 7u);
  EXPECT_EQ(coarse(40), 6u);
  EXPECT_EQ(coarse(32), 5u);
  EXPECT_EQ(lag_bins_for(2048).size(), 19u);
  EXPECT_EQ(lag_bins_for(471).size(), 18u);
  EXPECT_EQ(lag_bins_for(120).size(), 16u);
}

TEST(LagBinsFor, AreNeverFewerThanFour) {
  for (const std::size_t samples : {0u, 1u, 10u, 24u, 31u}) {
    EXPECT_EQ(lag_bins_for(samples).size(), 4u) << samples;
  }
}

TEST(LagBinsFor, BecomeNoFewerWithMoreSamples) {
  for (std::size_t samples = 1; samples < 600; ++samples) {
    EXPECT_GE(lag_bins_for(samples).size(), lag_bins_for(samples - 1).size());
  }
}

}  // namespace
}  // namespace ident
