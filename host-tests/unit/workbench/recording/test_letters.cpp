#include <gtest/gtest.h>

#include "workbench/recording/letters.hpp"

namespace workbench {
namespace {

TEST(Letters, AreThoseOfAscii) {
  EXPECT_EQ(lower_case("AZaz@[09Ä"), "azaz@[09Ä");
  EXPECT_TRUE(is_digit('0') && is_digit('9'));
  EXPECT_FALSE(is_digit('/') || is_digit(':') || is_digit('\xB2'));
}

}  // namespace
}  // namespace workbench
