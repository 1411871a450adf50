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

TEST_P(LagBins, ReachOneCycleBack) {
  EXPECT_EQ(GetParam().back().last, kEvidencePerCycle);
}

INSTANTIATE_TEST_SUITE_P(FewAndMany, LagBins,
                         testing::Values(std::span<const LagBin>(kAllLagBins),
                                         std::span<const LagBin>(kManyLagBins)));

// Of a window of so many samples, an eighth is the past of its first prediction.
TEST(LagBinsFor, AreAsManyAsTheWindowBears) {
  EXPECT_EQ(lag_bins_for(2048).size(), 12u);
  EXPECT_EQ(lag_bins_for(472).size(), 12u);  // 8 · 60 − 8
  EXPECT_EQ(lag_bins_for(471).size(), 11u);
  EXPECT_EQ(lag_bins_for(264).size(), 11u);  // 8 · 34 − 8
  EXPECT_EQ(lag_bins_for(263).size(), 10u);
  EXPECT_EQ(lag_bins_for(168).size(), 10u);
  EXPECT_EQ(lag_bins_for(112).size(), 9u);
  EXPECT_EQ(lag_bins_for(111).size(), 8u);
  EXPECT_EQ(lag_bins_for(80).size(), 8u);
  EXPECT_EQ(lag_bins_for(56).size(), 7u);
  EXPECT_EQ(lag_bins_for(40).size(), 6u);
  EXPECT_EQ(lag_bins_for(32).size(), 5u);
  EXPECT_EQ(lag_bins_for(2048, kManyLagBins).size(), 19u);
  EXPECT_EQ(lag_bins_for(471, kManyLagBins).size(), 18u);
  EXPECT_EQ(lag_bins_for(120, kManyLagBins).size(), 16u);
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
