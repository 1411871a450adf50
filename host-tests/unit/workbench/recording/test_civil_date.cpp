#include <gtest/gtest.h>

#include "workbench/recording/civil_date.hpp"

namespace workbench {
namespace {

TEST(CivilDate, GoesThereAndBack) {
  EXPECT_EQ(days_from_civil({1970, 1, 1}), 0);
  for (std::int32_t day = -200000; day < 200000; day += 37) {
    EXPECT_EQ(days_from_civil(civil_from_days(day)), day);
  }
}

TEST(CivilDate, KnowsLeapYears) {
  EXPECT_EQ(days_from_civil({2000, 3, 1}) - days_from_civil({2000, 2, 28}), 2);
  EXPECT_EQ(days_from_civil({1900, 3, 1}) - days_from_civil({1900, 2, 28}), 1);
}

}  // namespace
}  // namespace workbench
