#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "workbench/recording/resample.hpp"
#include "workbench/recording/times/rounded_times.hpp"

namespace workbench {
namespace {

// Steps of 2 s, each stamp up to `most` s off.
std::vector<double> scattered(double most) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> off(-most, most);
  std::vector<double> t;
  for (int k = 0; k < 500; ++k) t.push_back(100 + 2 * k + off(random));
  return t;
}

TEST(ScatteredTimes, HaveThePeriodOfTheirSteps) {
  const auto found = scattered_times(scattered(0.8));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->period_s, 2, 1e-3);
  EXPECT_NEAR(found->most_off_s, 0.8, 0.05);
}

TEST(ScatteredTimes, AreNoneWhereASampleIsMissing) {
  std::vector<double> t = scattered(0.1);
  t.erase(t.begin() + 250);
  EXPECT_FALSE(scattered_times(t));
}

TEST(ScatteredTimes, AreNoneWhereIntervalsAreOfAnyLength) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> interval(1, 3);
  std::vector<double> t = {0};
  for (int k = 0; k < 500; ++k) t.push_back(t.back() + interval(random));
  EXPECT_FALSE(scattered_times(t));
}

TEST(ScatteredTimes, KeepTheirRowsOneForOne) {
  TimedRows rows;
  rows.t = scattered(0.8);
  const std::size_t size = rows.t.size();
  for (std::size_t k = 0; k < size; ++k) {
    rows.line.push_back(static_cast<std::uint32_t>(k + 2));
    for (const Column column : {Column::u, Column::y}) {
      rows.values[static_cast<std::size_t>(column)].push_back(
          std::sin(static_cast<double>(k)));
    }
  }
  const std::vector<double> y = rows.values[static_cast<std::size_t>(Column::y)];
  Recording out;
  resample(std::move(rows), "a.csv", out);
  EXPECT_EQ(out.y, y);
  EXPECT_NEAR(out.period_s, 2, 1e-3);
  EXPECT_EQ(out.resampling.missing, 0u);
  ASSERT_EQ(out.resampling.notes.size(), 1u);
  EXPECT_NE(out.resampling.notes[0].find("taken as equally spaced"), std::string::npos);
}

}  // namespace
}  // namespace workbench
