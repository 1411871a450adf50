#include <gtest/gtest.h>

#include "workbench/recording/times/date_count.hpp"

namespace workbench {
namespace {

using Day = WrittenTime::Day;

constexpr std::int32_t kDay = 20526;  // 14 March 2026

TEST(DateDigits, OfAYearFirst) {
  const auto date = date_digits("20260314");
  ASSERT_TRUE(date);
  EXPECT_EQ(date->kind, Day::kKnown);
  EXPECT_EQ(date->day, kDay);
  EXPECT_FALSE(date_digits("20261314"));
}

TEST(DateDigits, OfTwoDigitYearsLeaveTheirOrderOpen) {
  EXPECT_EQ(date_digits("260314")->kind, Day::kAllTwoDigits);
  EXPECT_EQ(date_digits("260314", DateOrder::ymd)->day, kDay);
  EXPECT_EQ(date_digits("140326", DateOrder::dmy)->day, kDay);
  EXPECT_FALSE(date_digits("999999"));
}

TEST(DateDigits, OfExcel) {
  EXPECT_EQ(date_digits("46095")->day, kDay);
  EXPECT_EQ(date_digits("46095,00")->day, kDay);
  EXPECT_FALSE(date_digits("46095.5"));
  EXPECT_FALSE(date_digits("12345"));
}

TEST(DateDigits, NothingElse) {
  for (const char* cell : {"", "7", "-46095", "2026-03-14", "4609a", "202603141"}) {
    EXPECT_FALSE(date_digits(cell)) << cell;
  }
}

}  // namespace
}  // namespace workbench
