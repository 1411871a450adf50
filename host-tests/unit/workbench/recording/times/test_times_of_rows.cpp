#include <gtest/gtest.h>

#include "workbench/recording/times/times_of_rows.hpp"

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
      doubt_of_zones(zone_text({-360, open_zone("cst")}), zone_text({60, nullptr}));
  EXPECT_EQ(doubt.found, "CST (-06:00 or +08:00) beside +01:00");
}

TEST(TimesOfRows, KeepTheZoneAsItIsWritten) {
  TimesOfRows times;
  times.zone_word = "IST";
  EXPECT_EQ(zone_written(times), "");
  times.dated = true;
  EXPECT_EQ(zone_written(times), "IST");
  times.zone_word.clear();
  EXPECT_EQ(zone_written(times), "");
  times.zoned = true;
  times.zone_min = -360;
  EXPECT_EQ(zone_written(times), "-06:00");
  times.open_zone = open_zone("cst");
  EXPECT_EQ(zone_written(times), "CST");
}

}  // namespace
}  // namespace workbench
