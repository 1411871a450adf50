#include <gtest/gtest.h>

#include "workbench/recording/time_unit.hpp"

namespace workbench {
namespace {

TEST(TimeUnit, SecondsOfOne) {
  EXPECT_EQ(seconds_of_unit("ms"), 1e-3);
  EXPECT_EQ(seconds_of_unit("\xC2\xB5s"), 1e-6);
  EXPECT_EQ(seconds_of_unit("Min."), 60);
  EXPECT_EQ(seconds_of_unit("Std"), 3600);
}

TEST(TimeUnit, NoneForAnythingElse) {
  EXPECT_EQ(seconds_of_unit("m3/h"), 0);
  EXPECT_EQ(seconds_of_unit(""), 0);
}

TEST(TimeUnit, InOtherLanguages) {
  EXPECT_EQ(seconds_of_unit("hrs"), 3600);
  EXPECT_EQ(seconds_of_unit("мин"), 60);
  EXPECT_EQ(seconds_of_unit("毫秒"), 1e-3);
  EXPECT_EQ(seconds_of_unit("分"), 60);
  EXPECT_EQ(seconds_of_unit("10ms"), 0);
}

TEST(TimeUnit, AtTheEndOfAName) {
  EXPECT_EQ(unit_in_name("TimeMs"), 1e-3);
  EXPECT_EQ(unit_in_name("TimeMS"), 1e-3);
  EXPECT_EQ(unit_in_name("RelTime_ms"), 1e-3);
  EXPECT_EQ(unit_in_name("elapsedMin"), 60);
  for (const char* name : {"Time", "Items", "ms", "", "Time (s)"}) {
    EXPECT_EQ(unit_in_name(name), 0) << name;
  }
}

TEST(ClockForm, NamesTheUnitOfTheLastOfTwoNumbers) {
  for (const char* form : {"mm:ss", "M:SS", "mm:ss.0", "min:sec"}) {
    EXPECT_EQ(seconds_of_clock_form(form), 1) << form;
  }
  EXPECT_EQ(seconds_of_clock_form("hh:mm"), 60);
  for (const char* form : {"", ":", "hh:mm:ss", "s", "mm:", "a:b"}) {
    EXPECT_EQ(seconds_of_clock_form(form), 0) << form;
  }
}

}  // namespace
}  // namespace workbench
