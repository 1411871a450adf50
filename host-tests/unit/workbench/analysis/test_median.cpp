#include <gtest/gtest.h>

#include "workbench/analysis/median.hpp"

namespace workbench {
namespace {

TEST(Median, IsTheMiddleOrTheMeanOfTheTwoThere) {
  EXPECT_EQ(median({3}), 3);
  EXPECT_EQ(median({5, 1, 9}), 5);
  EXPECT_EQ(median({5, 1, 9, 2}), 3.5);
}

}  // namespace
}  // namespace workbench
