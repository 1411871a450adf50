#include <gtest/gtest.h>

#include <string>

#include "wire/decimal.hpp"

namespace wire {
namespace {

TEST(Decimal, ReadsWhatDbcFilesHold) {
  double value = 0;
  EXPECT_TRUE(parse_decimal("0.01", value));
  EXPECT_EQ(value, 0.01);
  EXPECT_TRUE(parse_decimal("-273.15", value));
  EXPECT_EQ(value, -273.15);
  EXPECT_TRUE(parse_decimal("+1E-005", value));
  EXPECT_EQ(value, 1e-5);
  EXPECT_TRUE(parse_decimal("3.05175781250E-005", value));
  EXPECT_EQ(value, 3.05175781250E-005);
  EXPECT_TRUE(parse_decimal("18446744073709551615", value));
  EXPECT_EQ(value, 18446744073709551615.0);
  EXPECT_TRUE(parse_decimal("-1.7976931348623157E+308", value));
  EXPECT_NEAR(value / -1.7976931348623157E+308, 1, 1e-14);
  EXPECT_TRUE(parse_decimal("1e-400", value));
  EXPECT_EQ(value, 0);
  EXPECT_TRUE(parse_decimal("0e99999999999", value));
  EXPECT_EQ(value, 0);
  EXPECT_TRUE(parse_decimal(".5", value));
  EXPECT_EQ(value, 0.5);
  EXPECT_TRUE(parse_decimal("5.", value));
  EXPECT_EQ(value, 5);
  EXPECT_TRUE(parse_decimal(std::string(400, '0') + "7", value));
  EXPECT_EQ(value, 7);
}

TEST(Decimal, RefusesEverythingElse) {
  double value = 42;
  for (const char* text : {"", "-", ".", "e5", "1e", "1e+", "1.2.3", "1,5", " 1", "1 ",
                           "nan", "inf", "0x10", "1e309", "1e99999999999", "--1"}) {
    EXPECT_FALSE(parse_decimal(text, value)) << text;
  }
  EXPECT_EQ(value, 42);
}

}  // namespace
}  // namespace wire
