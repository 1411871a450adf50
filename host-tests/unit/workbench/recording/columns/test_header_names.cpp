#include <gtest/gtest.h>

#include <string>

#include "workbench/recording/columns/header_names.hpp"

namespace workbench {
namespace {

TEST(HeaderNames, RepeatedOnes) {
  EXPECT_TRUE(has_repeated_names(split_line("Time,Value,Value", ',')));
  EXPECT_FALSE(has_repeated_names(split_line("Time,,,Value", ',')));
}

TEST(HeaderNames, StandUnderThoseAbove) {
  std::vector<LayoutColumn> columns(3);
  columns[0].name = column_name("Time");
  put_names_above(split_line(",A.OP,A.PV", ','), split_line("Time,Value,Value", ','),
                  columns);
  EXPECT_EQ(columns[0].name.text, "Time");
  EXPECT_EQ(columns[1].name.text, "A.OP Value");
  EXPECT_EQ(columns[2].name.part, Part::kY);
}

TEST(HeaderNames, MoveFromTimesToTheirValues) {
  for (const char* names : {"A.OP,,A.PV,\n", "A.OP,,A.PV\n"}) {
    std::string text = names;
    for (int i = 10; i < 40; ++i) {
      const std::string time = "2026-05-13 06:00:" + std::to_string(i);
      text +=
          time + ",4" + std::to_string(i) + ',' + time + ",6" + std::to_string(i) + '\n';
    }
    const std::string file = "a.csv";
    const CsvLayout layout = layout_of(text, file, {{Column::u, Column::y}, {}});
    ASSERT_EQ(layout.columns.size(), 4U);
    EXPECT_EQ(layout.columns[0].name.part, Part::kTime);
    EXPECT_EQ(layout.columns[1].name.text, "A.OP");
    EXPECT_EQ(layout.columns[3].name.text, "A.PV");
  }
}

TEST(HeaderNames, OneShortStandsOverDateAndClock) {
  std::string text = "Tag;A.MV;A.PV\nUnit;%;bar\n";
  for (int i = 10; i < 40; ++i) {
    text += "2026/05/13;06:00:" + std::to_string(i) + ";4" + std::to_string(i) + ";6" +
            std::to_string(i) + '\n';
  }
  const std::string file = "a.csv";
  const CsvLayout layout = layout_of(text, file, {{Column::u, Column::y}, {}});
  ASSERT_EQ(layout.columns.size(), 4U);
  EXPECT_EQ(layout.columns[2].name.text, "A.MV");
  EXPECT_EQ(layout.columns[2].name.unit, "%");
  EXPECT_EQ(layout.columns[3].name.unit, "bar");
  EXPECT_EQ(layout.columns[3].name.text, "A.PV");
}

TEST(HeaderNames, ATitleIsNoneOfThem) {
  std::vector<LayoutColumn> columns(2);
  put_names_above(split_line("Title,", ','), split_line("Value,Value", ','), columns);
  EXPECT_EQ(columns[0].name.text, "");
}

TEST(HeaderNames, ALineAboveMayEndWithItsLastTag) {
  std::string text = "FIC101.OP,,,FIC101.PV\nTime,Value,,Time,Value\n";
  for (int i = 10; i < 30; ++i) {
    const std::string at = "17-Mar-26 08:15:" + std::to_string(i);
    text += at + ",52.6,," + at + ",110.4\n";
  }
  const CsvLayout layout =
      layout_of(text, "f.csv", {{Column::t, Column::u, Column::y}, {}});
  ASSERT_EQ(layout.columns.size(), 5U);
  EXPECT_EQ(layout.columns[1].name.text, "FIC101.OP Value");
  EXPECT_EQ(layout.columns[4].name.text, "FIC101.PV Value");
}

TEST(HeaderNames, StandBehindMarks) {
  std::string text = "#MS;#SP;#CMD\n#Elapsed (ms);#SetPoint;#Cmd\n";
  for (int i = 0; i < 20; ++i) text += std::to_string(1000 + 50 * i) + ".5;1.5;2.5\n";
  const CsvLayout layout =
      layout_of(text, "f.csv", {{Column::t, Column::u, Column::y}, {}});
  ASSERT_EQ(layout.columns.size(), 3U);
  EXPECT_EQ(layout.columns[2].name.key, "cmd");
  EXPECT_EQ(layout.first_row_line, 3U);
}

TEST(HeaderNames, CellsBehindTheLastAreFoundByTheirNumber) {
  std::string text = "Time (s),Set,Current\n";
  for (int i = 0; i < 20; ++i) text += std::to_string(i) + ",1.5,2.5,3.5,4.5\n";
  const CsvLayout layout =
      layout_of(text, "f.csv", {{Column::t, Column::u, Column::y}, {}});
  ASSERT_EQ(layout.columns.size(), 5U);
  EXPECT_EQ(layout.columns[4].name.text, "#5");
  EXPECT_TRUE(layout.columns[4].name.key.empty());
  text = "Time (s),OP,PV\n";
  for (int i = 10; i < 30; ++i) text += std::to_string(i) + ",52,624,110,386\n";
  EXPECT_EQ(
      layout_of(text, "f.csv", {{Column::t, Column::u, Column::y}, {}}).columns.size(),
      3U);
}

}  // namespace
}  // namespace workbench
