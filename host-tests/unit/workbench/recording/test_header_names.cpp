#include <gtest/gtest.h>

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

TEST(HeaderNames, ATitleIsNoneOfThem) {
  std::vector<LayoutColumn> columns(2);
  put_names_above(split_line("Title,", ','), split_line("Value,Value", ','), columns);
  EXPECT_EQ(columns[0].name.text, "");
}

}  // namespace
}  // namespace workbench
