// Numbers that count minutes, hours or days, rounded to a few decimals.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "workbench/recording/times/date_count.hpp"

namespace workbench {
namespace {

// Rows `period_s` apart from `first_s` on, in units of `unit_s`, with so many decimals.
std::vector<double> rounded(double first_s, double period_s, double unit_s, int decimals,
                            int rows = 600) {
  std::vector<double> out;
  const double parts = std::pow(10, decimals);
  for (int i = 0; i < rows; ++i) {
    const double at = (first_s + period_s * i) / unit_s;
    out.push_back(std::round(at * parts) / parts);
  }
  return out;
}

TEST(RoundedCount, FindsTheWholeSecondsThatWereRounded) {
  for (const int decimals : {4, 5, 6, 7}) {
    const auto days = rounded_count(rounded(29700, 1, 86400, decimals), 86400);
    ASSERT_TRUE(days) << decimals;
    EXPECT_EQ(days->period_s, 1);
    EXPECT_DOUBLE_EQ(days->t[300] - days->t[0], 300);
  }
  EXPECT_EQ(rounded_count(rounded(0, 5, 3600, 3), 3600)->period_s, 5);
  EXPECT_EQ(rounded_count(rounded(7200, -2, 3600, 4), 3600)->period_s, -2);
}

TEST(RoundedCount, LeavesOthersAlone) {
  EXPECT_FALSE(rounded_count(rounded(0, 60, 60, 2), 60));           // not rounded
  EXPECT_FALSE(rounded_count(rounded(0, 0.5, 86400, 6), 86400));    // no whole seconds
  EXPECT_FALSE(rounded_count(rounded(0, 1, 86400, 4, 30), 86400));  // too few to tell
  EXPECT_FALSE(rounded_count({}, 86400));
  EXPECT_FALSE(rounded_count(rounded(0, 1, 1e-3, 0), 1e-3));
  std::vector<double> gap = rounded(0, 1, 86400, 6);
  for (std::size_t i = 300; i < gap.size(); ++i) gap[i] += 0.001;
  EXPECT_FALSE(rounded_count(gap, 86400));
}

TEST(RoundedCount, SaysWhatItDid) {
  TimesOfRows out;
  ASSERT_TRUE(take_rounded_count(rounded(0, 1, 86400, 5), 86400, out));
  ASSERT_EQ(out.notes.size(), 1U);
  EXPECT_EQ(out.notes[0], "the times are rounded to 0.864 s: taken as 1 s apart");
  EXPECT_FALSE(take_rounded_count({0, 1, 2}, 60, out));
}

TEST(RoundedDays, AreSpacedAsExportsAre) {
  EXPECT_TRUE(are_rounded_days(rounded(29700, 1, 86400, 7)));
  EXPECT_FALSE(are_rounded_days(rounded(0, 54, 86400, 6)));  // 0.625 ms
  EXPECT_FALSE(are_rounded_days(rounded(0, 0.001, 1, 3)));
}

TEST(PartsOfADay, AreBelowOneAndCloseTogether) {
  EXPECT_TRUE(may_be_parts_of_day({0.5, 0.5001157, 0.5002315})) << "10 s, or 0.1 ms";
  EXPECT_TRUE(may_be_parts_of_day({0.5, 0.5001, 0.5003}));
  EXPECT_FALSE(may_be_parts_of_day({0.0027, 0.00271, 0.00272})) << "0.864 s, or 10 us";
  EXPECT_FALSE(may_be_parts_of_day({0.5, 0.501, 0.502}));
  EXPECT_FALSE(may_be_parts_of_day({1, 1.0001, 1.0002}));
  EXPECT_FALSE(may_be_parts_of_day({}));
}

}  // namespace
}  // namespace workbench
