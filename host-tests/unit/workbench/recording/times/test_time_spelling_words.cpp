#include <gtest/gtest.h>

#include "workbench/recording/times/time_spelling.hpp"

namespace workbench {
namespace {

TEST(TimeWords, MonthsInBothLanguages) {
  for (const char* may : {"may", "mai"}) EXPECT_EQ(month_named(may), 5) << may;
  EXPECT_EQ(month_named("m\xC3\xA4rz"), 3);
  EXPECT_EQ(month_named("dezember"), 12);
  EXPECT_EQ(month_named("decem"), 12);
  EXPECT_EQ(month_named("monday"), 0);
}

TEST(TimeWords, WeekdaysShortAndLong) {
  for (const char* day : {"mo", "tues", "mittwoch", "samstag", "sunday"}) {
    EXPECT_TRUE(is_weekday(day)) << day;
  }
  for (const char* other : {"", "day", "may", "m"}) {
    EXPECT_FALSE(is_weekday(other)) << other;
  }
}

}  // namespace
}  // namespace workbench
