#include <gtest/gtest.h>

#include "workbench/recording/times/time_spelling.hpp"
#include "workbench/recording/written_time.hpp"

namespace workbench {
namespace {

TEST(TimeSpelling, OfManyLanguagesIsOneInstant) {
  const auto truth = written_time("2026-03-14 08:00:00");
  for (const char* cell :
       {"2026年3月14日 8時00分00秒", "2026年03月14日08时00分00秒",
        "2026년 3월 14일 8시 0분 0초", "2026/3/14 午前 08:00:00",
        "2026/3/14 上午 08:00:00", "2026-03-14 오전 8:00:00", "14.03.2026 08.00.00",
        "14-mar-2026 kl. 08.00.00", "14. März 2026 um 08:00:00", "14 févr. 2026 08:00:00",
        "14 мар 2026 08:00:00", "14-MAR-26 08.00.00.000000 AM",
        "14 marca 2026 08:00:00"}) {
    const auto time = written_time(cell);
    ASSERT_TRUE(time) << cell;
    EXPECT_EQ(time->seconds, truth->seconds) << cell;
    const bool february =
        std::string_view(cell).find("f\xC3\xA9v") != std::string_view::npos;
    if (time->kind == WrittenTime::Day::kKnown) {
      EXPECT_EQ(time->day, truth->day - (february ? 28 : 0)) << cell;
    }
  }
}

TEST(TimeSpelling, OfHalvesOfTheDay) {
  EXPECT_EQ(plain_time("14/3/2026 08:00:00 a. m."), "14/3/2026 08:00:00 AM");
  EXPECT_EQ(plain_time("2026/3/14 午後 08:00:00"), "2026/3/14 08:00:00 PM");
}

TEST(TimeSpelling, OfJapaneseEras) {
  for (const char* cell :
       {"R8/3/14 08:00:00", "令和8年3月14日 8時00分00秒", "R08.03.14 08:00:00"}) {
    const auto time = written_time(cell);
    ASSERT_TRUE(time) << cell;
    EXPECT_EQ(time->day, written_time("2026-03-14")->day) << cell;
    EXPECT_EQ(time->seconds, 8 * 3600) << cell;
  }
  EXPECT_EQ(written_time("令和元年5月1日 08:00:00")->day,
            written_time("2019-05-01")->day);
  EXPECT_EQ(written_time("H31/4/30")->day, written_time("2019-04-30")->day);
  EXPECT_FALSE(written_time("R8 314"));
}

TEST(TimeSpelling, OfClocksWithDots) {
  EXPECT_EQ(dotted_clock("14.05.30"), "14:05:30");
  EXPECT_EQ(dotted_clock("8.05.30.250"), "8:05:30.250");
  for (const char* cell : {"24.05.30", "14.60.30", "14.05.60", "14.05", "14.05.2026"}) {
    EXPECT_FALSE(dotted_clock(cell)) << cell;
  }
}

TEST(TimeSpelling, OfLiteralsOfPlcs) {
  EXPECT_EQ(plain_time("T#1h2m3s400ms"), "1:02:03.400000");
  EXPECT_EQ(plain_time("TIME#2d1h"), "49:00:00.000000");
  EXPECT_EQ(plain_time("LTIME#20s5us"), "0:00:20.000005");
  EXPECT_EQ(plain_time("t#45000ms"), "0:00:45.000000");
  EXPECT_EQ(plain_time("0h 0m 20.5s"), "0:00:20.500000");
  EXPECT_EQ(plain_time("TOD#14:30:00.250"), "14:30:00.250");
  EXPECT_EQ(plain_time("DT#2026-05-13-14:30:00"), "2026-05-13 14:30:00");
  EXPECT_EQ(written_time("T#26h0m1s")->seconds, 26 * 3600 + 1);
  for (const char* cell :
       {"20 m", "5 s", "T#", "T#3s2m", "T#1x", "3m2", "#1", "DT#2026"}) {
    EXPECT_FALSE(plain_time(cell)) << cell;
  }
}

TEST(TimeSpelling, LeavesTheRest) {
  for (const char* cell :
       {"2026-03-14 08:00:00", "44.979", "Bad Input", "14.03.26", "", "1 234.567"}) {
    EXPECT_FALSE(plain_time(cell)) << cell;
  }
}

}  // namespace
}  // namespace workbench
