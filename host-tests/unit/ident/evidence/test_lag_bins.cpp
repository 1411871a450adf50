#include <gtest/gtest.h>

#include "ident/evidence/lag_bins.hpp"

namespace ident {
namespace {

TEST(LagBins, FollowEachOtherWithoutAGap) {
  EXPECT_EQ(kAllLagBins.front().first, 1);
  for (std::size_t b = 0; b < kAllLagBins.size(); ++b) {
    EXPECT_LE(kAllLagBins[b].first, kAllLagBins[b].last);
    if (b > 0) {
      EXPECT_EQ(kAllLagBins[b].first, kAllLagBins[b - 1].last + 1);
    }
  }
}

TEST(LagBins, GrowWithTheirAge) {
  int width = 1;
  for (const LagBin& bin : kAllLagBins) {
    EXPECT_GE(bin.last - bin.first + 1, width);
    width = bin.last - bin.first + 1;
  }
}

TEST(LagBins, ReachOneCycleBack) {
  EXPECT_EQ(kAllLagBins.back().last, kEvidencePerCycle);
}

// Of a window of so many samples, an eighth is the past of its first prediction.
TEST(LagBins, AreAsManyAsTheWindowBears) {
  EXPECT_EQ(lag_bins_for(2048), 12u);
  EXPECT_EQ(lag_bins_for(472), 12u);  // 8 · 60 − 8
  EXPECT_EQ(lag_bins_for(471), 11u);
  EXPECT_EQ(lag_bins_for(264), 11u);  // 8 · 34 − 8
  EXPECT_EQ(lag_bins_for(263), 10u);
  EXPECT_EQ(lag_bins_for(168), 10u);
  EXPECT_EQ(lag_bins_for(112), 9u);
  EXPECT_EQ(lag_bins_for(111), 8u);
  EXPECT_EQ(lag_bins_for(80), 8u);
  EXPECT_EQ(lag_bins_for(56), 7u);
  EXPECT_EQ(lag_bins_for(40), 6u);
  EXPECT_EQ(lag_bins_for(32), 5u);
}

TEST(LagBins, AreNeverFewerThanFour) {
  for (const std::size_t samples : {0u, 1u, 10u, 24u, 31u}) {
    EXPECT_EQ(lag_bins_for(samples), 4u) << samples;
  }
}

TEST(LagBins, BecomeNoFewerWithMoreSamples) {
  for (std::size_t samples = 1; samples < 600; ++samples) {
    EXPECT_GE(lag_bins_for(samples), lag_bins_for(samples - 1));
  }
}

}  // namespace
}  // namespace ident
