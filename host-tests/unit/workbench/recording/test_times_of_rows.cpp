#include <gtest/gtest.h>

#include "workbench/recording/times_of_rows.hpp"

namespace workbench {
namespace {

TEST(TimesOfRows, ClockTextOfDatedTimes) {
  TimesOfRows times;
  EXPECT_EQ(clock_text(times, 0), "");
  times.dated = true;
  times.origin_day = 20576;  // 3 May 2026
  times.origin_seconds = 86390;
  EXPECT_EQ(clock_text(times, 5), "2026-05-03T23:59:55");
  EXPECT_EQ(clock_text(times, 10.25), "2026-05-04T00:00:00.250");
  times.zoned = true;
  times.zone_min = 120;
  EXPECT_EQ(clock_text(times, 0), "2026-05-04T01:59:50+02:00");
}

TEST(TimesOfRows, DaysInWords) {
  EXPECT_EQ(date_text(20576), "3 May 2026");
  EXPECT_EQ(date_text(-1), "31 December 1969");
}

TEST(TimesOfRows, SayWhichZonesAreInDoubt) {
  const TimesOfRows::Doubt doubt =
      doubt_of_zones({-360, open_zone("cst")}, {60, nullptr});
  EXPECT_EQ(doubt.found, "CST (-06:00 or +08:00) beside +01:00");
}

}  // namespace
}  // namespace workbench
