#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "workbench/recording/times/date_count.hpp"

namespace workbench {
namespace {

using Values = std::vector<double>;

std::string note_of(const Values& values, double unit_s = 0, bool seconds_only = false) {
  const auto count = date_count(values, unit_s, seconds_only);
  return count ? std::string(count->note) : "none";
}

TEST(DateCount, KnowsCountsFrom1970) {
  EXPECT_EQ(date_count({1.7786826e9, 1.778682605e9}, 0, false)->unit_s, 1);
  EXPECT_EQ(date_count({1.7786826e12, 1.778682605e12}, 0, true)->unit_s, 1e-3);
  EXPECT_FALSE(date_count({1.7786826e12, 1.778682605e12}, 1, false));
}

TEST(DateCount, KnowsTicksOfWindowsAndNet) {
  EXPECT_NE(note_of({1.3423156200e17, 1.3423156205e17}).find("Windows"),
            std::string::npos);
  EXPECT_NE(note_of({6.3914279400e17, 6.3914279405e17}).find(".NET"), std::string::npos);
  EXPECT_EQ(note_of({1.3423156200e17, 1.3423156205e17}, 1e-9), "none");
}

TEST(DateCount, KnowsDaysByStepsThatNoSecondsHave) {
  constexpr double kFiveS = 5.0 / 86400;
  const Values excel{46155.5, 46155.5 + kFiveS, 46155.5 + 2 * kFiveS};
  EXPECT_NE(note_of(excel).find("Excel"), std::string::npos);
  EXPECT_NE(note_of(excel, 0, true).find("Excel"), std::string::npos);
  EXPECT_EQ(note_of({46155.5, 46155.51, 46155.52}, 0, true), "none");
  const Values matlab{740115.5, 740115.5 + kFiveS, 740115.5 + 2 * kFiveS};
  EXPECT_NE(note_of(matlab).find("MATLAB"), std::string::npos);
  EXPECT_EQ(note_of({740115.5, 740115.51, 740115.52}), "none");
  EXPECT_EQ(note_of({740115, 740116, 740117}), "none");
}

TEST(DateCount, MedianOfStepsThatDiffer) {
  EXPECT_EQ(median_step({0, 0, 2, 1, 1, 3}), 2);
  EXPECT_EQ(median_step({7, 7}), 0);
  EXPECT_EQ(median_step({}), 0);
}

TEST(DateCount, SecondsOfADayMayBeMeant) {
  const auto found = date_count({30000, 30000.02, 30000.04}, 0, false);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->open);
  EXPECT_FALSE(date_count({30000, 30000.02, 30000.04}, 86400, false)->open);
  EXPECT_FALSE(date_count({30000, 30000.02, 30000.04}, 1, false));
  EXPECT_FALSE(date_count({46155.5, 46155.5 + 1.0 / 86400}, 0, false)->open);
}

}  // namespace
}  // namespace workbench
