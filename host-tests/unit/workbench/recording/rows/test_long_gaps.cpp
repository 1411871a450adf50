#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "workbench/recording/rows/long_gaps.hpp"

namespace workbench {
namespace {

Recording sine(double period_samples, std::size_t size) {
  Recording out;
  out.period_s = 1;
  for (std::size_t k = 0; k < size; ++k) {
    const auto at = static_cast<double>(k);
    out.t.push_back(at);
    out.u.push_back(50);
    out.y.push_back(std::sin(2 * std::numbers::pi * at / period_samples));
  }
  return out;
}

void hold(Recording& recording, SampleRange gap) {
  for (std::size_t k = gap.first; k < gap.last; ++k) {
    recording.y[k] = recording.y[gap.first - 1];
  }
  recording.resampling.gaps.push_back(gap);
}

TEST(LongGaps, AreKeptWhereTheSignalWouldHaveMoved) {
  Recording recording = sine(200, 1000);
  hold(recording, {344, 356});  // a seventeenth of the period, where it turns
  hold(recording, {600, 640});
  keep_long_gaps(recording);
  ASSERT_EQ(recording.resampling.gaps.size(), 1u);
  EXPECT_EQ(recording.resampling.gaps[0].first, 600u);
}

TEST(LongGaps, OfAWholePeriodAreLong) {
  Recording recording = sine(40, 1000);
  hold(recording, {300, 340});
  keep_long_gaps(recording);
  EXPECT_EQ(recording.resampling.gaps.size(), 1u);
}

TEST(LongGaps, OfSignalsAtRestAreNone) {
  Recording recording = sine(40, 100);
  recording.y.assign(100, 3);
  hold(recording, {30, 80});
  keep_long_gaps(recording);
  EXPECT_TRUE(recording.resampling.gaps.empty());
}

TEST(LongGaps, AreKeptWhereUMovedMeanwhile) {
  Recording recording = sine(40, 1000);
  recording.y.assign(1000, 3);
  for (std::size_t k = 0; k < 1000; ++k) recording.u[k] = k < 310 ? 40 : 60;
  hold(recording, {200, 220});
  hold(recording, {300, 320});
  for (std::size_t k = 300; k < 320; ++k) recording.u[k] = recording.u[299];
  keep_long_gaps(recording);
  ASSERT_EQ(recording.resampling.gaps.size(), 1u);
  EXPECT_EQ(recording.resampling.gaps[0].first, 300u);
}

TEST(ShortestGap, IsTenInstantsOfARegularRecording) {
  std::vector<double> t;
  for (int k = 0; k < 100; ++k) t.push_back(5 * k + (k >= 50 ? 3600 : 0));
  EXPECT_EQ(shortest_gap(t, spacing_of(t)), 10u);
}

TEST(ShortestGap, IsLongerWhereOnlyChangesAreStored) {
  std::vector<double> t = {0};
  for (int k = 0; k < 100; ++k) t.push_back(t.back() + (k % 5 == 0 ? 8 : 1));
  EXPECT_EQ(shortest_gap(t, spacing_of(t)), 24u);
}

TEST(ShortestGap, IsNeverReachedWhereIntervalsAreOfAnyLength) {
  std::vector<double> t = {0};
  for (int k = 0; k < 100; ++k) t.push_back(t.back() + 1 + 0.37 * (k % 13) * (k % 13));
  EXPECT_EQ(shortest_gap(t, spacing_of(t)), std::numeric_limits<std::size_t>::max());
}

}  // namespace
}  // namespace workbench
