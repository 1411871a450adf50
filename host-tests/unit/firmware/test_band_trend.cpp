#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "firmware/band_trend.hpp"

namespace firmware {
namespace {

constexpr std::int64_t kDay_s = 86'400;
constexpr std::int64_t kStart_s = 1'700'000'000;
constexpr double kLimit = 4;

// Three windows a day with 3 % of noise.
struct Valve {
  void live(int days, double per_day) {
    for (int k = 0; k < days; ++k) {
      day += 1;
      band += per_day;
      for (int window = 0; window < 3; ++window) {
        trend.add(kStart_s + day * kDay_s, band * (1 + 0.03 * normal(random)));
      }
    }
  }
  [[nodiscard]] Trend find() const { return trend.find(kStart_s + day * kDay_s, kLimit); }
  BandTrend trend;
  int day = 0;
  double band = 2;
  std::mt19937 random{1};
  std::normal_distribution<double> normal;
};

TEST(BandTrend, FindsWearAndSaysWhenItReachesTheLimit) {
  Valve valve;
  valve.live(120, 0.01);
  const Trend trend = valve.find();
  ASSERT_TRUE(trend.stands);
  EXPECT_NEAR(trend.slope, 0.01, 0.001);
  EXPECT_LT(trend.low, 0.01);
  EXPECT_GT(trend.high, 0.01);
  EXPECT_NEAR(trend.days, (kLimit - 3.2) / 0.01, 12);
  EXPECT_LT(trend.days_early, trend.days);
  EXPECT_GT(trend.days_late, trend.days);
}

TEST(BandTrend, IsSilentWhereNothingWears) {
  Valve valve;
  for (int week = 0; week < 52; ++week) {
    valve.live(7, 0);
    EXPECT_FALSE(valve.find().stands) << week;
  }
}

TEST(BandTrend, NeedsWeeks) {
  Valve valve;
  valve.live(7 * BandTrend::kFewestWeeks - 8, 0.05);
  EXPECT_FALSE(valve.find().fitted);
  valve.live(8 + BandTrend::kConfirmDays, 0.05);
  EXPECT_TRUE(valve.find().stands);
}

TEST(BandTrend, GoesOnOverAnOutage) {
  Valve valve;
  valve.live(40, 0.02);
  valve.day += 30;
  valve.band += 0.6;
  valve.live(30, 0.02);
  const Trend trend = valve.find();
  ASSERT_TRUE(trend.stands);
  EXPECT_NEAR(trend.slope, 0.02, 0.002);
}

TEST(BandTrend, ForgetsWhatIsHalfAYearOld) {
  Valve valve;
  valve.live(60, 0.02);
  ASSERT_TRUE(valve.find().stands);
  valve.day += BandTrend::kDays;
  EXPECT_FALSE(valve.find().fitted);
}

TEST(BandTrend, ABandBeyondTheLimitNeedsAttentionNow) {
  Valve valve;
  valve.live(150, 0.03);
  EXPECT_EQ(valve.find().days, 0);
}

TEST(BandTrend, ABandThatFallsReachesNoLimit) {
  Valve valve;
  valve.live(120, -0.01);
  const Trend trend = valve.find();
  EXPECT_TRUE(trend.stands);
  EXPECT_TRUE(std::isnan(trend.days));
}

TEST(BandTrend, TakesOnlyWhatCanBe) {
  BandTrend trend;
  trend.add(-5, 1);
  trend.add(kStart_s, std::nan(""));
  trend.add(kStart_s + BandTrend::kDays * kDay_s, 1);
  trend.add(kStart_s, 1);  // too old by now
  EXPECT_FALSE(trend.find(kStart_s, kLimit).fitted);
}

}  // namespace
}  // namespace firmware
