#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "workbench/recording/times/time_column.hpp"
#include "workbench/recording/times/times_of_rows.hpp"

namespace workbench {
namespace {

TimeColumn dates(const std::vector<std::string>& cells) {
  TimeColumn column(TimeForm::kDate, 0, false, {});
  for (const std::string& cell : cells) EXPECT_TRUE(column.add(cell, "", 0)) << cell;
  return column;
}

TimesOfRows numbers(const std::vector<double>& values, double unit_s = 0) {
  TimeColumn column(TimeForm::kNumber, unit_s, false, {});
  for (const double value : values) column.add(value);
  return column.take();
}

TEST(TimeColumn, DecidesTheOrderOfDayAndMonthFromAllRows) {
  for (const auto& [cells, start] :
       std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"03/04/2026 10:00", "13/04/2026 10:00"}, "2026-04-03T10:00:00"},
           {{"03/04/2026 10:00", "03/14/2026 10:00"}, "2026-03-04T10:00:00"},
           {{"30/04/2026 23:59", "01/05/2026 00:00"}, "2026-04-30T23:59:00"},
           {{"03/04/2026 23:59", "04/04/2026 00:00"}, "2026-04-03T23:59:00"},
           {{"03/04/2026 23:59", "03/05/2026 00:00"}, "2026-03-04T23:59:00"},
           {{"05/05/2026 10:00", "05/05/2026 10:01"}, "2026-05-05T10:00:00"},
       }) {
    TimeColumn column = dates(cells);
    EXPECT_TRUE(column.ambiguity().empty()) << cells[0];
    EXPECT_EQ(clock_text(column.take(), 0), start);
  }
}

TEST(TimeColumn, AsksWhereItStaysOpen) {
  const auto readings = dates({"03/04/2026 10:00", "04/05/2026 10:01"}).ambiguity();
  ASSERT_EQ(readings.size(), 2U);
  EXPECT_EQ(readings[0].date, "3 April 2026");
  EXPECT_EQ(readings[1].date, "4 March 2026");
  EXPECT_TRUE(dates({"13/04/2026", "04/13/2026"}).unreadable());
}

TEST(TimeColumn, TellsEpochsDaysAndUnitsApart) {
  EXPECT_EQ(numbers({0, 0.5, 1}).t, (std::vector<double>{0, 0.5, 1}));
  EXPECT_EQ(numbers({0, 0.5, 1}, 60).t, (std::vector<double>{0, 30, 60}));
  EXPECT_EQ(numbers({1.78e9, 1.78e9 + 1}).t.front(), 1.78e9);
  EXPECT_EQ(clock_text(numbers({1.78e9, 1.78e9 + 1}), 1.78e9), "2026-05-28T20:26:40Z");
  EXPECT_EQ(numbers({1.78e12, 1.78e12 + 500}).t, (std::vector<double>{0, 0.5}));
  EXPECT_EQ(numbers({1.78e15, 1.78e15 + 500}).t, (std::vector<double>{0, 0.0005}));
  const TimesOfRows days = numbers({46145.5, 46145.5 + 1 / 86400.0});
  EXPECT_EQ(days.t, (std::vector<double>{0, 1}));
  EXPECT_EQ(clock_text(days, 0), "2026-05-03T12:00:00");
  EXPECT_EQ(numbers({46145, 46146, 46147}).t.front(), 46145);  // seconds
}

TEST(TimeColumn, NumbersBesideDatesAreTimesOfDay) {
  TimeColumn column(TimeForm::kDate, 0, false, {});
  EXPECT_TRUE(column.add("20260314", 235955, 6, 0.25));
  EXPECT_TRUE(column.add("20260315", 0, 1, 0.25));
  EXPECT_FALSE(column.add("n/a", 5, 1, 0));
  ASSERT_TRUE(column.settle());
  const TimesOfRows times = column.take();
  EXPECT_EQ(times.t, (std::vector<double>{0, 5}));
  EXPECT_EQ(clock_text(times, 0), "2026-03-14T23:59:55.250");
  EXPECT_NE(times.notes.at(0).find("HHMMSS"), std::string::npos);
}

TEST(TimeColumn, NumbersBesideDatesThatAreNoTimesDoNotSettle) {
  TimeColumn column(TimeForm::kDate, 0, false, {});
  EXPECT_TRUE(column.add("2026-03-14", 800, 3, 0));
  EXPECT_TRUE(column.add("2026-03-14", 801, 3, 0));
  EXPECT_FALSE(column.settle());
}

TEST(TimeColumn, ZonesAreTakenOffAndShown) {
  TimesOfRows times =
      dates({"2026-10-25T02:59:59+02:00", "2026-10-25T02:00:00+01:00"}).take();
  EXPECT_EQ(times.t, (std::vector<double>{0, 1}));
  EXPECT_EQ(clock_text(times, 0), "2026-10-25T02:59:59+02:00");
}

TEST(TimeColumn, TheTimeOfDayPassesMidnight) {
  TimeColumn column(TimeForm::kClock, 0, false, {});
  for (const char* cell : {"23:59:59", "00:00:00", "00:00:01"}) {
    EXPECT_TRUE(column.add(cell, "", 0));
  }
  EXPECT_EQ(column.take().t, (std::vector<double>{0, 1, 2}));
}

TEST(TimeOrder, TurnsNewestFirst) {
  TimesOfRows times;
  times.t = {3, 2, 1, 0};
  EXPECT_TRUE(put_in_order(times).turned);
  EXPECT_EQ(times.t, (std::vector<double>{0, 1, 2, 3}));
}

TEST(TimeOrder, FindsAStepBack) {
  TimesOfRows times;
  times.t = {0, 2, 1};
  const TimeOrder order = put_in_order(times);
  EXPECT_FALSE(order.turned);
  EXPECT_EQ(order.step_back, 2U);
}

TEST(TimeOrder, TakesOffDaylightSavingOnlyWhereItIs) {
  TimesOfRows autumn = dates({"2026-10-25 02:59:58", "2026-10-25 02:59:59",
                              "2026-10-25 02:00:00", "2026-10-25 02:00:01"})
                           .take();
  EXPECT_FALSE(put_in_order(autumn).step_back.has_value());
  EXPECT_EQ(autumn.t, (std::vector<double>{0, 1, 2, 3}));

  TimesOfRows noon = dates({"2026-10-25 12:59:58", "2026-10-25 12:59:59",
                            "2026-10-25 12:00:00", "2026-10-25 12:00:01"})
                         .take();
  EXPECT_TRUE(put_in_order(noon).step_back.has_value());

  TimesOfRows hole = dates({"2026-03-29 01:20:00", "2026-03-29 01:20:01",
                            "2026-03-29 02:20:02", "2026-03-29 02:20:03"})
                         .take();
  EXPECT_TRUE(put_in_order(hole).notes.empty());
  EXPECT_EQ(hole.t.back(), 3603);
}

TEST(TimeColumn, AsksForUnitsThatNobodyKnows) {
  TimeColumn column(TimeForm::kNumber, 0, false, {});
  column.unit_is_unknown("'10ms'");
  for (const double value : {0., 1., 2.}) column.add(value);
  const TimesOfRows times = column.take();
  ASSERT_TRUE(times.doubt);
  EXPECT_NE(times.doubt->found.find("10ms"), std::string::npos);
  EXPECT_NE(times.doubt->advice.find("--time"), std::string::npos);
}

TEST(TimeColumn, AsksWhereNumbersHaveTwoMeanings) {
  std::vector<double> minutes;
  for (int i = 0; i < 300; ++i) minutes.push_back((600 + i) / 60 * 100 + i % 60);
  EXPECT_TRUE(numbers(minutes).doubt);
  EXPECT_TRUE(numbers({30000, 30000.02, 30000.04}).doubt);
  for (const auto& [unit_s, last] : {std::pair(1., 299.), std::pair(60., 17940.)}) {
    TimeColumn column(TimeForm::kNumber, unit_s, false, {});
    column.unit_is_given();
    for (const double value : minutes) column.add(value);
    const TimesOfRows times = column.take();
    EXPECT_FALSE(times.doubt);
    EXPECT_EQ(times.t.back(), last);
  }
}

TEST(TimeColumn, TheUserSaysWhatTheLastNumberOfAClockIs) {
  for (const auto& [unit_s, last] : {std::pair(1., 60.), std::pair(60., 3600.)}) {
    TimeColumn column(TimeForm::kClock, unit_s, false, {});
    column.unit_is_given();
    for (const char* cell : {"00:00", "00:30", "01:00"}) {
      EXPECT_TRUE(column.add(cell, "", 0));
    }
    EXPECT_EQ(column.take().t.back(), last);
  }
}

TEST(TimeColumn, AZoneNobodyKnowsIsTheSameInAllRows) {
  TimeColumn column = dates({"2026-05-03 10:00 IST", "2026-05-03 10:01 IST"});
  EXPECT_FALSE(column.add("2026-05-03 10:02 AST", "", 0));
  const TimesOfRows times = column.take();
  EXPECT_FALSE(times.zoned);
  EXPECT_EQ(clock_text(times, 0), "2026-05-03T10:00:00");
  EXPECT_NE(times.notes.at(0).find("IST"), std::string::npos);
}

TEST(TimeOrder, ClocksGoBackOnAnyNight) {
  TimeColumn column = dates({"2026-04-04 23:50", "2026-04-04 23:55", "2026-04-04 23:00",
                             "2026-04-04 23:05", "2026-04-04 23:10"});
  TimesOfRows times = column.take();
  const TimeOrder order = put_in_order(times);
  EXPECT_FALSE(order.step_back);
  EXPECT_EQ(times.t.back(), 1200);
}

TEST(TimeColumn, RefusesOpenZonesBesideOthers) {
  const std::string day = "2026-11-01 0";
  const TimesOfRows autumn =
      dates({day + "1:59:59 CDT", day + "1:00:00 CST", day + "1:00:01 CST"}).take();
  EXPECT_FALSE(autumn.doubt);
  EXPECT_EQ(autumn.t, (std::vector<double>{0, 1, 2}));
  EXPECT_FALSE(dates({day + "1:00 CST", day + "1:01 CST"}).take().doubt);
  const TimesOfRows mixed = dates({day + "1:00 CST", day + "7:01 UTC"}).take();
  ASSERT_TRUE(mixed.doubt);
  EXPECT_EQ(mixed.doubt->found, "CST (-06:00 or +08:00) beside +00:00");
}

TEST(TimeColumn, AsksWhetherTwoNumbersOfTimeElapsedAreMinutesAndSeconds) {
  const auto taken = [](double unit_s) {
    TimeColumn column(TimeForm::kClock, unit_s, false, std::nullopt);
    column.is_elapsed();
    if (unit_s > 0) column.unit_is_given();
    for (const char* cell : {"00:00", "00:01", "00:02"}) {
      EXPECT_TRUE(column.add(cell, "", 0));
    }
    return column.take();
  };
  EXPECT_TRUE(taken(0).doubt);
  EXPECT_FALSE(taken(1).doubt);
  EXPECT_EQ(taken(1).t.back(), 2);
  EXPECT_EQ(taken(60).t.back(), 120);
}

TEST(TimeColumn, TakesRoundedPartsOfADayAsDaysOrAsks) {
  const auto taken = [](int decimals, double gap) {
    TimeColumn column(TimeForm::kNumber, 0, false, std::nullopt);
    const double parts = std::pow(10, decimals);
    for (int i = 0; i < 600; ++i) {
      const double at = (29700 + i + (i > 300 ? gap : 0)) / 86400;
      column.add(std::round(at * parts) / parts);
    }
    return column.take();
  };
  for (const int decimals : {4, 5, 6, 7}) {
    const TimesOfRows times = taken(decimals, 0);
    EXPECT_FALSE(times.doubt) << decimals;
    EXPECT_NEAR(times.t[500] - times.t[0], 500, 1e-6) << decimals;
  }
  EXPECT_TRUE(taken(6, 40).doubt);
}

TEST(TimeColumn, ADayWhoseOrderIsOpenIsReadByItself) {
  const auto column = [](const char* last) {
    TimeColumn out(TimeForm::kDate, 0, false, std::nullopt);
    for (const char* cell : {"03/04/2026 08:00:00", "03/04/2026 08:00:01", last}) {
      EXPECT_TRUE(out.add(cell, "", 0));
    }
    return out;
  };
  TimeColumn one = column("03/04/2026 08:00:02");
  EXPECT_TRUE(one.ambiguity().empty());
  ASSERT_TRUE(one.one_open_day());
  const TimesOfRows times = one.take();
  EXPECT_FALSE(times.dated);
  EXPECT_EQ(times.t.back(), 2);
  ASSERT_EQ(times.notes.size(), 1U);
  EXPECT_EQ(times.notes[0],
            "the date may be 3 April 2026 or 4 March 2026: all times are of that day");
  EXPECT_EQ(column("04/05/2026 08:00:00").ambiguity().size(), 2U);
  EXPECT_EQ(column("03/04/2026 07:00:02").ambiguity().size(), 2U);
}

}  // namespace
}  // namespace workbench
