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

}  // namespace
}  // namespace workbench
