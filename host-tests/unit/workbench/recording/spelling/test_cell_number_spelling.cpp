#include <gtest/gtest.h>

#include "workbench/recording/spelling/cell_number.hpp"

namespace workbench {
namespace {

TEST(NumberSpelling, OfOtherLetters) {
  EXPECT_EQ(plain_number("\xE2\x88\x92\x34\x34.9"), "-44.9");
  EXPECT_EQ(plain_number("44.9-"), "-44.9");
  EXPECT_EQ(plain_number("44.979\xC2\xA0"), "44.979");
  EXPECT_EQ(plain_number("\xE2\x80\xAF\x37"), "7");
  EXPECT_EQ(plain_number("４４．９７９"), "44.979");
  EXPECT_EQ(plain_number("٤٤٫٩"), "44.9");
  EXPECT_EQ(plain_number("4.49790D+01"), "4.49790E+01");
  EXPECT_EQ(plain_number("'44.9"), "44.9");
  EXPECT_EQ(plain_number("=\"44.9\""), "44.9");
}

TEST(NumberSpelling, LeavesTheRest) {
  for (const char* cell : {"44.9", "-7", "1e3", "Bad", "D", "", "(44.9)", "2026-03-14"}) {
    EXPECT_FALSE(plain_number(cell)) << cell;
  }
}

TEST(NumberSpelling, IndianGroupsInThrees) {
  EXPECT_EQ(plain_number("1,23,456"), "000,123,456");
  EXPECT_EQ(plain_number("-1,23,45,678.9"), "-012,345,678.9");
  for (const char* cell : {"1,234,567", "12,345", "1,2,345", "123,45,678", "1.23.456"}) {
    EXPECT_FALSE(plain_number(cell)) << cell;
  }
}

TEST(NumberSpelling, BlanksAround) {
  EXPECT_EQ(without_blanks(" \xC2\xA0 4 5\xE2\x80\xAF"), "4 5");
  EXPECT_EQ(without_blanks("\xC2\xA0"), "");
}

TEST(NumberSpelling, ASignApartFromItsNumber) {
  EXPECT_EQ(plain_number("+  52.624"), "+52.624");
  EXPECT_EQ(plain_number("- 1.5"), "-1.5");
  EXPECT_NE(plain_number("+ x"), "+x");
  EXPECT_EQ(plain_number("+ "), "+");
}

}  // namespace
}  // namespace workbench
