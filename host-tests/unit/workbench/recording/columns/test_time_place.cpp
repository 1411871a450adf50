#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "workbench/recording/column_choice.hpp"
#include "workbench/recording/columns/time_place.hpp"
#include "workbench/recording/input_error.hpp"

namespace workbench {
namespace {

std::optional<TimePlace> place_of(const std::string& head, const std::string& first,
                                  const std::string& time = "") {
  std::string text = head + '\n';
  for (int k = 0; k < 9; ++k) text += first + std::to_string(k) + ",4,6\n";
  const CsvLayout layout = layout_of(text, "a.csv", {});
  const std::vector<NamedSignal> candidates = candidates_of(layout);
  const std::string file = "a.csv";
  ColumnNames names;
  names.time = time;
  return TimeFinder(layout, file, names, candidates).find();
}

using Indices = std::vector<std::size_t>;

TEST(TimePlace, TakesPartsWhereNoColumnIsAWholeTime) {
  const auto alone = place_of("Hour,Minute,Second,OP,PV", "14,30,1");
  ASSERT_TRUE(alone);
  EXPECT_EQ(alone->form, TimeForm::kClock);
  EXPECT_EQ(columns_of(*alone), (Indices{0, 1, 2}));
  const auto dated = place_of("Datum,Hour,Minute,Second,OP,PV", "13.05.2026,14,30,1");
  ASSERT_TRUE(dated);
  EXPECT_EQ(dated->form, TimeForm::kDate);
  EXPECT_EQ(columns_of(*dated), (Indices{0, 1, 2, 3}));
  const auto whole =
      place_of("Hour,Minute,Second,Time,OP,PV", "14,30,1,2026-05-13 14:30:1");
  ASSERT_TRUE(whole);
  EXPECT_EQ(columns_of(*whole), Indices{3});
}

TEST(TimePlace, TakesAllPartsWhereOneIsNamed) {
  const auto named = place_of("Hour,Minute,Second,OP,PV", "14,30,1", "Minute");
  ASSERT_TRUE(named);
  EXPECT_EQ(named->parts, (Indices{0, 1, 2}));
  const auto as_number = place_of("Hour,Minute,Second,OP,PV", "14,30,1", "Second [s]");
  ASSERT_TRUE(as_number);
  EXPECT_EQ(columns_of(*as_number), Indices{2});
}

TEST(TimePlace, AsksForTheRestOfADateBesideHours) {
  EXPECT_THROW((void)place_of("Day,Hour,Minute,Second,OP,PV", "13,14,30,1"), InputError);
  EXPECT_THROW((void)place_of("Month,Day,Hour,Minute,Second,OP,PV", "5,13,14,30,1"),
               InputError);
}

TEST(TimePlace, TakesPartsOfTheSecondBesideItsClock) {
  for (const char* name : {"ms", "msec", "Millisecond", "Millisecond(s)", "MSecCol"}) {
    const auto place =
        place_of("Date,Time," + std::string(name) + ",OP,PV", "13.05.2026,14:30:00,30");
    ASSERT_TRUE(place) << name;
    EXPECT_EQ(columns_of(*place), (Indices{0, 1, 2})) << name;
    EXPECT_EQ(place->millis_s, 1e-3) << name;
  }
}

TEST(TimePlace, TakesMicrosecondsWhereTheyBeginAnewEachSecond) {
  const auto rows = [](const std::string& head, bool counts) {
    std::string text = head + '\n';
    for (int k = 0; k < 40; ++k) {
      const int us = counts ? k * 100000 : k % 10 * 100000;
      text += "2026/03/17,08:15:" + std::to_string(10 + k / 10) + ',' +
              std::to_string(us) + ",4.5,6.5\n";
    }
    const CsvLayout layout = layout_of(text, "a.csv", {});
    const std::string file = "a.csv";
    const ColumnNames names;
    const std::vector<NamedSignal> candidates = candidates_of(layout);
    return TimeFinder(layout, file, names, candidates).find();
  };
  const auto place = rows("Date,Time,us,CH3,CH4", false);
  ASSERT_TRUE(place && place->millis);
  EXPECT_EQ(*place->millis, 2U);
  EXPECT_EQ(place->millis_s, 1e-6);
  EXPECT_FALSE(rows("Date,Time,us,CH3,CH4", true)->millis);
}

TEST(TimePlace, TBesideATimeIsATemperature) {
  const auto column_of = [](const std::string& head, const ColumnNames& names) {
    std::string text = head + '\n';
    for (int k = 0; k < 40; ++k) {
      text += std::to_string(k) + ',' + std::to_string(20 + k % 7) + ",4.5\n";
    }
    const CsvLayout layout = layout_of(text, "a.csv", {});
    const std::string file = "a.csv";
    const std::vector<NamedSignal> candidates = candidates_of(layout);
    const auto place = TimeFinder(layout, file, names, candidates).find();
    return place ? static_cast<int>(place->column) : -1;
  };
  EXPECT_EQ(column_of("time,T,OP", {}), 0);
  EXPECT_EQ(column_of("Timestamp,T,OP", {}), 0);
  EXPECT_EQ(column_of("T,PV,OP", {}), 0) << "the contract's t";
  EXPECT_EQ(column_of("PV,T,OP", {}), 1);
  EXPECT_EQ(column_of("PV,T,OP", {.y = "T"}), -1) << "the user says what it is";
  EXPECT_THROW(column_of("t,T,OP", {}), InputError);
  EXPECT_EQ(column_of("t,T,OP", {.y = "T"}), 0);
}

TEST(TimePlace, AHeaderNamesTheFormOfAClock) {
  const auto place = place_of("Time (mm:ss),OP,PV", "00:0");
  ASSERT_TRUE(place);
  EXPECT_EQ(place->unit_s, 1);
  EXPECT_TRUE(place->unit_given);
  EXPECT_TRUE(place->unknown_unit.empty());
}

TEST(TimePlace, AUnitMayStandBehindANameThatHasOne) {
  for (const char* time : {"Temps (xx) [min]", "temps [min]", "#1 [min]"}) {
    const auto place = place_of("Temps (xx),OP,PV", "1", time);
    ASSERT_TRUE(place) << time;
    EXPECT_EQ(place->unit_s, 60) << time;
    EXPECT_TRUE(place->unit_given) << time;
  }
  EXPECT_EQ(place_of("Temps (mn),OP,PV", "1")->unit_s, 60);
}

}  // namespace
}  // namespace workbench
