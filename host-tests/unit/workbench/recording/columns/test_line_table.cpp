#include <gtest/gtest.h>

#include <string_view>
#include <vector>

#include "workbench/recording/columns/line_table.hpp"

namespace workbench {
namespace {

LineTable table_of(std::vector<std::string_view> texts, char separator) {
  static std::vector<SampleLine> lines;
  lines.clear();
  for (const std::string_view text : texts) lines.push_back({text, 0, lines.size() + 1});
  return {lines, separator};
}

TEST(LineTable, TellsWhatCellsHold) {
  EXPECT_EQ(kind_of(""), CellKind::kEmpty);
  EXPECT_EQ(kind_of("-1.5e3"), CellKind::kNumber);
  EXPECT_EQ(kind_of("47,3 %"), CellKind::kNumber);
  EXPECT_EQ(kind_of("12 m³/h"), CellKind::kNumber);
  EXPECT_EQ(kind_of("2026-05-13 14:30"), CellKind::kDateTime);
  EXPECT_EQ(kind_of("13.05.2026"), CellKind::kDate);
  EXPECT_EQ(kind_of("14:30:00"), CellKind::kClock);
  EXPECT_EQ(kind_of("No Data"), CellKind::kBad);
  EXPECT_EQ(kind_of("FIC101.OP"), CellKind::kText);
  EXPECT_EQ(kind_of("12 apples"), CellKind::kText);
}

TEST(LineTable, FindsColumnsAndTheFirstRow) {
  const LineTable table = table_of(
      {"Trend", "Time,OP,PV", "2026-05-13 14:30:00,1.5,2", "2026-05-13 14:30:01,1.5,3"},
      ',');
  EXPECT_EQ(table.width(), 3U);
  EXPECT_EQ(table.first_row(), 2U);
  EXPECT_EQ(table.content(0), Content::kDateTime);
  EXPECT_EQ(table.content(1), Content::kNumber);
  EXPECT_EQ(table.held(1), 1);
  EXPECT_EQ(table.held(2), 0);
  EXPECT_EQ(table.merit(), 4U);
}

TEST(LineTable, KnowsColumnsThatCount) {
  const LineTable table = table_of({"350.00,9,1.1", "352.00,9,1.1", "354.01,9,1.2",
                                    "356.00,4,1.4", "358.00,4,1.3", "360.00,4,1.0"},
                                   ',');
  EXPECT_TRUE(table.counts(0));
  EXPECT_FALSE(table.counts(1));
  EXPECT_FALSE(table.counts(2));
  EXPECT_NEAR(table.held(1), 0.8, 1e-12);
  EXPECT_FALSE(table_of({"1,2", "2,2"}, ',').counts(0));  // too few to say
}

TEST(LineTable, TakesNamesBelowNumbersOfThePreamble) {
  const LineTable table = table_of({"Samples;40;40", "X0;0.0;0.0", "t;OP;PV", "0;1;2",
                                    "1;1;3", "2;4;4", "3;4;5", "4;4;6"},
                                   ';');
  EXPECT_EQ(table.first_row(), 3U);
}

TEST(LineTable, LosesNoRowsAboveNamesThatAreRepeated) {
  const LineTable table =
      table_of({"t;OP;PV", "0;1;2", "1;1;3", "t;OP;PV", "0;1;2", "1;1;3", "2;4;4"}, ';');
  EXPECT_EQ(table.first_row(), 1U);
}

TEST(LineTable, CountsSeveralBlanksAsOne) {
  const LineTable table = table_of(
      {"  t    OP   PV", "  0.0  1.5  2 ", " 10.0  1.5 \t3", "100.0  2.5  4"}, ' ');
  EXPECT_EQ(table.width(), 3U);
  EXPECT_EQ(table.cells(2)[2].text, "3");
}

TEST(LineTable, CountsThatWereRoundedStayCounts) {
  const LineTable table =
      table_of({"0,0.17,10,0,1.1", "0.2,0.35,11,1,1.3", "0.41,0.48,13,2,1.4",
                "0.61,0.51,14,2,1.6", "0.82,0.6,16,4,1.7", "1.03,0.8,17,5,1.8"},
               ',');
  EXPECT_TRUE(table.counts(0));
  for (const std::size_t column : {1U, 2U, 3U, 4U}) {
    EXPECT_FALSE(table.counts(column)) << column;
  }
}

}  // namespace
}  // namespace workbench
