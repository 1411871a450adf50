#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "workbench/recording/times/rounded_times.hpp"

namespace workbench {
namespace {

std::vector<double> stamps(double period_s, double step, std::size_t rows) {
  std::vector<double> out;
  for (std::size_t i = 0; i < rows; ++i) {
    out.push_back(step * std::floor(period_s * static_cast<double>(i) / step + 1e-9));
  }
  return out;
}

TEST(RoundedTimes, AreSpreadWhereRowsShareStamps) {
  const auto found = unrounded(stamps(0.7, 1, 600));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->step, 1);
  EXPECT_EQ(found->period_s, 0.7);
  EXPECT_NEAR(found->t[599] - found->t[0], 0.7 * 599, 1e-6);
}

TEST(RoundedTimes, AreSpreadWhereIntervalsAlternate) {
  const auto found = unrounded(stamps(5, 0.864, 600));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->period_s, 5);
}

TEST(RoundedTimes, KeepTheirGaps) {
  std::vector<double> cut = stamps(5, 60, 600);
  cut.erase(cut.begin() + 200, cut.begin() + 300);
  const auto found = unrounded(cut);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->period_s, 5);
  EXPECT_NEAR(found->t[200] - found->t[199], 505, 1e-6);
}

TEST(RoundedTimes, AreNoneWhereASampleIsMissingOrTimesJitter) {
  std::vector<double> one = stamps(1, 1, 600);
  one.erase(one.begin() + 300);
  EXPECT_FALSE(unrounded(one));
  std::vector<double> jitter;
  double t = 0;
  for (int i = 0; i < 600; ++i) jitter.push_back(t += i % 7 < 3 && i % 50 < 25 ? 2 : 1);
  EXPECT_FALSE(unrounded(jitter));
  EXPECT_FALSE(unrounded(stamps(5, 5, 600)));
}

}  // namespace
}  // namespace workbench
