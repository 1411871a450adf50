#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "workbench/recording/written_time.hpp"

namespace workbench {
namespace {

using Day = WrittenTime::Day;
using namespace std::chrono_literals;

std::int32_t days(std::chrono::year_month_day date) {
  return static_cast<std::int32_t>(
      std::chrono::sys_days(date).time_since_epoch().count());
}

const std::int32_t kWrittenDay = days(2026y / 5 / 3);

// Seconds from the start of 3 May 2026; NAN where it is no known time.
double seconds_of(const std::string& cell) {
  const auto time = written_time(cell);
  if (!time || time->kind != Day::kKnown) return __builtin_nan("");
  return 86400.0 * (time->day - kWrittenDay) + time->seconds;
}

TEST(WrittenTime, ReadsEverySpellingOfOneInstant) {
  for (const std::string cell : {"2026-05-03 14:30:00",
                                 "2026-05-03T14:30:00",
                                 "2026-05-03T14:30:00Z",
                                 "2026-05-03T16:30:00+02:00",
                                 "2026-05-03T10:30:00-0400",
                                 "2026/05/03 14:30:00",
                                 "2026/05/03 14:30:00;000",
                                 "20260503T143000",
                                 "2026-123T14:30:00",
                                 "2026/123 14:30:00",
                                 "20260503143000",
                                 "3.5.2026 14:30",
                                 "03.05.26 14:30:00",
                                 "03-May-26 14:30:00",
                                 "03-Mai-2026 14:30:00,000",
                                 "3. Mai 2026 14:30:00",
                                 "03-MAY-26 14:30:00.0",
                                 "May 3, 2026 2:30:00 PM",
                                 "Sunday, May 3, 2026 2:30 PM",
                                 "Sun May 03 16:30:00 CEST 2026",
                                 "2026-05-03 02:30:00 p.m.",
                                 "2026-05-03 14:30:00 UTC",
                                 "So 03.05.2026 14:30 Uhr",
                                 "2026-05-03 14:30:00:000"}) {
    EXPECT_EQ(seconds_of(cell), 52200) << cell;
  }
}

TEST(WrittenTime, CountsTheDaysOfTheYear) {
  EXPECT_EQ(seconds_of("2026-365"), 86400 * 242);
  EXPECT_TRUE(written_time("2028-366"));
  for (const std::string cell : {"2026-366", "2026-000", "2026-1234", "26-123"}) {
    EXPECT_FALSE(written_time(cell)) << cell;
  }
}

TEST(WrittenTime, KeepsFractions) {
  EXPECT_DOUBLE_EQ(seconds_of("2026-05-03T00:00:00.1234567Z"), 0.1234567);
  EXPECT_DOUBLE_EQ(seconds_of("03.05.2026 00:00:00,250"), 0.25);
  EXPECT_DOUBLE_EQ(seconds_of("03.05.2026 00:00:00:250"), 0.25);
}

TEST(WrittenTime, KnowsMidnightAndNoonOfTwelveHours) {
  EXPECT_EQ(seconds_of("2026-05-03 12:00:00 AM"), 0);
  EXPECT_EQ(seconds_of("2026-05-03 12:00:00 PM"), 43200);
}

TEST(WrittenTime, LeavesTheOrderOpenWhereItIs) {
  EXPECT_EQ(written_time("03/04/2026")->kind, Day::kYearLast);
  EXPECT_EQ(written_time("03-04-26 10:00")->kind, Day::kAllTwoDigits);
  EXPECT_EQ(written_time("03/04/2026", DateOrder::mdy)->day, days(2026y / 3 / 4));
  EXPECT_EQ(written_time("03/04/2026", DateOrder::dmy)->day, days(2026y / 4 / 3));
  EXPECT_EQ(written_time("26/04/03", DateOrder::ymd)->day, days(2026y / 4 / 3));
  EXPECT_EQ(written_time("2026-04-03", DateOrder::dmy)->day, days(2026y / 4 / 3));
}

TEST(WrittenTime, FindsAnOrderByItsName) {
  for (const DateOrder order : kDateOrders) {
    EXPECT_EQ(date_order_named(name_of(order)), order);
  }
  EXPECT_EQ(date_order_named("ydm"), std::nullopt);
}

TEST(WrittenTime, ReadsClockTimesAlone) {
  const auto time = written_time("23:59:59.5");
  ASSERT_TRUE(time.has_value());
  EXPECT_EQ(time->kind, Day::kNone);
  EXPECT_EQ(time->seconds, 86399.5);
  EXPECT_FALSE(time->short_clock);
}

TEST(WrittenTime, ReadsTimeElapsed) {
  EXPECT_EQ(written_time("100:05:00")->seconds, 360300);
  EXPECT_EQ(written_time("4 days 04:05:00")->seconds, 360300);
  EXPECT_EQ(written_time("1 day, 0:00:02")->seconds, 86402);
  EXPECT_FALSE(written_time("2026-05-03 25:00:00").has_value());
  EXPECT_FALSE(written_time("4 days").has_value());
}

TEST(WrittenTime, TellsTwoNumbersFromThree) {
  const auto time = written_time("59:50.5");
  ASSERT_TRUE(time.has_value());
  EXPECT_TRUE(time->short_clock);
  EXPECT_TRUE(time->decimal);
  EXPECT_EQ(time->seconds / 60, 59 * 60 + 50.5);
  EXPECT_FALSE(written_time("2:30 PM")->short_clock);
}

TEST(WrittenTime, RefusesWhatIsNoTime) {
  for (const std::string cell :
       {"", "42", "1.5", "20260503", "2026-02-30", "2026-13-01 00:00", "13/13/2026",
        "2026-05-03 25:00", "10:61", "FIC-101", "03-Xyz-26", "2026-05-03 14:30:00 xyz",
        "2026-05-03 14:30:00 1", "1.2.3.4", "30.02.2026"}) {
    EXPECT_FALSE(written_time(cell).has_value()) << cell;
  }
}

TEST(WrittenTime, DigitsToMinutesAndMilliseconds) {
  EXPECT_EQ(seconds_of("202605031430"), 52200);
  EXPECT_EQ(seconds_of("20260503143000.250"), 52200.25);
  EXPECT_EQ(seconds_of("20260503143000250"), 52200.25);
  EXPECT_FALSE(written_time("201205031430")) << "or 3 May 2020, 14:30";
  EXPECT_FALSE(written_time("202613031430"));
}

TEST(WrittenTime, ADotBehindTheDay) {
  EXPECT_EQ(seconds_of("2026. 05. 03. 14:30:00"), 52200);
}

TEST(WrittenTime, ZonesAreKeptByName) {
  const auto time = written_time("Sun May 03 14:30:00 IST 2026");
  ASSERT_TRUE(time);
  EXPECT_EQ(time->zone_word, "IST");
  EXPECT_FALSE(time->has_zone);
  EXPECT_EQ(
      seconds_of("Sun May 03 2026 14:30:00 GMT+0200 (Central European Summer Time)"),
      52200 - 7200);
  EXPECT_FALSE(written_time("14:30:00 IST"));
}

}  // namespace
}  // namespace workbench
