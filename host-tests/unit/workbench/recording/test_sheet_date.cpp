#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "workbench/recording/sheet_date.hpp"

namespace workbench {
namespace {

TEST(SheetDate, IsToldFromTheFormat) {
  const std::vector<std::pair<std::string, SheetDate>> kinds = {
      {"General", SheetDate::kNone},
      {"0.00", SheetDate::kNone},
      {"#,##0.00\\ \"days\"", SheetDate::kNone},
      {"[Red]0.0;[Blue]0.0", SheetDate::kNone},
      {"0.00E+00", SheetDate::kNone},
      {"dd.mm.yyyy", SheetDate::kDate},
      {"[$-407]d. mmmm yyyy;@", SheetDate::kDate},
      {"mmm", SheetDate::kDate},
      {"yyyy-mm-dd hh:mm:ss.000", SheetDate::kDateTime},
      {"m/d/yy h:mm AM/PM", SheetDate::kDateTime},
      {"hh:mm:ss", SheetDate::kClock},
      {"[h]:mm:ss", SheetDate::kDuration},
      {"[mm]:ss", SheetDate::kDuration},
  };
  for (const auto& [code, kind] : kinds) EXPECT_EQ(date_of_code(code), kind) << code;
  EXPECT_EQ(built_in_date(0), SheetDate::kNone);
  EXPECT_EQ(built_in_date(14), SheetDate::kDate);
  EXPECT_EQ(built_in_date(22), SheetDate::kDateTime);
  EXPECT_EQ(built_in_date(21), SheetDate::kClock);
  EXPECT_EQ(built_in_date(46), SheetDate::kDuration);
}

TEST(SheetDate, IsWrittenToTheMillisecond) {
  const double half_past_two = 46155 + 52200.25 / 86400;  // 13 May 2026
  EXPECT_EQ(sheet_date(half_past_two, SheetDate::kDateTime, false),
            "2026-05-13 14:30:00.250");
  EXPECT_EQ(sheet_date(half_past_two - 1462, SheetDate::kDateTime, true),
            "2026-05-13 14:30:00.250");
  EXPECT_EQ(sheet_date(46155, SheetDate::kDate, false), "2026-05-13");
  EXPECT_EQ(sheet_date(46155.5, SheetDate::kDate, false), "2026-05-13 12:00:00.000");
  EXPECT_EQ(sheet_date(46155, SheetDate::kDateTime, false), "2026-05-13 00:00:00.000");
  EXPECT_EQ(sheet_date(0.75, SheetDate::kClock, false), "18:00:00.000");
  EXPECT_EQ(sheet_date(46155.75, SheetDate::kClock, false), "2026-05-13 18:00:00.000");
  EXPECT_EQ(sheet_date(1.5, SheetDate::kDuration, false), "129600.000");
  // A second before midnight in the arithmetic of days is midnight.
  EXPECT_EQ(sheet_date(46154.9999999999, SheetDate::kDateTime, false),
            "2026-05-13 00:00:00.000");
}

TEST(SheetDate, LeavesOtherNumbers) {
  EXPECT_EQ(sheet_date(47.25, SheetDate::kNone, false), "47.25");
  EXPECT_EQ(sheet_date(-1, SheetDate::kDate, false), "-1");
  EXPECT_EQ(sheet_date(1e9, SheetDate::kDateTime, false), "1000000000");
}

}  // namespace
}  // namespace workbench
