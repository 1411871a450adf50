#include <gtest/gtest.h>

#include <string>

#include "workbench/recording/header_names.hpp"

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

}  // namespace
}  // namespace workbench
