#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "workbench/recording/spelling/mark_doubt.hpp"

namespace workbench {
namespace {

using Numbers = std::vector<std::pair<std::string, double>>;

MarkDoubt of(const Numbers& numbers) {
  MarkDoubt doubt;
  for (const auto& [text, value] : numbers) doubt.add(text, value);
  return doubt;
}

TEST(MarkDoubt, TellsHowANumberIsWritten) {
  for (const char* text : {"7", "-998", "+0"}) {
    EXPECT_EQ(number_shape(text), NumberShape::kWhole) << text;
  }
  for (const char* text : {"1.002", "-12,345", "998.000"}) {
    EXPECT_EQ(number_shape(text), NumberShape::kThree) << text;
  }
  for (const char* text : {"0.998", "1.02", "1,234,567", "1234.567", "1e3", "", "-"}) {
    EXPECT_EQ(number_shape(text), NumberShape::kOther) << text;
  }
}

TEST(MarkDoubt, WholeNumbersThatRunOnAsThousands) {
  EXPECT_TRUE(of({{"996", 996}, {"1.002", 1.002}, {"999", 999}}).likely_thousands());
  EXPECT_FALSE(of({{"21", 21}, {"21.125", 21.125}, {"22", 22}}).likely_thousands());
  EXPECT_FALSE(of({{"0", 0}, {"1.002", 1.002}}).likely_thousands());
}

TEST(MarkDoubt, OneOtherNumberSettlesIt) {
  const MarkDoubt doubt = of({{"996", 996}, {"1.002", 1.002}, {"0.5", 0.5}});
  EXPECT_TRUE(doubt.settled());
  EXPECT_FALSE(doubt.likely_thousands());
  EXPECT_FALSE(doubt.open());
}

TEST(MarkDoubt, NothingButMarksStaysOpen) {
  EXPECT_TRUE(of({{"4.508", 4.508}, {"4.668", 4.668}}).open());
  EXPECT_FALSE(of({{"4.508", 4.508}, {"4", 4}}).open());
}

TEST(MarkDoubt, CommasAreOfDecimalsUnlessTheyRunOnAsThousands) {
  EXPECT_FALSE(of({{"44,979", 44.979}, {"60,000", 60}}).open());
  EXPECT_TRUE(of({{"996", 996}, {"1,002", 1.002}, {"999", 999}}).likely_thousands());
}

TEST(FractionDoubt, DigitsOfOneWidthWithZerosInFront) {
  const auto fractions = [](const std::vector<const char*>& numbers) {
    FractionDoubt doubt;
    for (const char* number : numbers) doubt.add(number);
    return doubt;
  };
  EXPECT_TRUE(fractions({"50", "07", "99"}).are_likely());
  EXPECT_FALSE(fractions({"50", "17", "99"}).are_likely());
  EXPECT_FALSE(fractions({"50", "07", "100"}).are_likely());
  EXPECT_FALSE(fractions({"5", "0", "9"}).are_likely());
  EXPECT_FALSE(fractions({"50", "07", "-9"}).are_digits());
  EXPECT_FALSE(fractions({"50", "07.5"}).are_digits());
  EXPECT_FALSE(fractions({}).are_digits());
}

}  // namespace
}  // namespace workbench
