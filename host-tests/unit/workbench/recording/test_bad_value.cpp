#include <gtest/gtest.h>

#include <string>

#include "workbench/recording/bad_value.hpp"

namespace workbench {
namespace {

TEST(BadValue, WordsOfHistoriansAreGapsInEveryFile) {
  for (const std::string cell :
       {"Bad", "BAD INPUT", "No Data", "I/O Timeout", "Digital State 246", "Pt Created",
        "#N/A", "#DIV/0!", "#NV", "null", "---", "Comm Fail", "<Null>", "ungültig"}) {
    EXPECT_TRUE(says_no_value(cell, false)) << cell;
  }
}

TEST(BadValue, NaNIsAGapInExportsOnly) {
  for (const std::string cell : {"NaN", "nan", "1.#QNAN", "-1.#IND", "-"}) {
    EXPECT_TRUE(says_no_value(cell, true)) << cell;
    EXPECT_FALSE(says_no_value(cell, false)) << cell;
  }
}

TEST(BadValue, TypingMistakesAndInfinitiesAreNone) {
  for (const std::string cell :
       {"abc", "12..3", "1O", "inf", "", "oops", "#", "1.#INF"}) {
    EXPECT_FALSE(says_no_value(cell, true)) << cell;
  }
}

Quality second_of(const std::string& other, const std::string& cell) {
  QualityScale scale;
  static_cast<void>(scale.add(other));
  const double code = scale.add(cell);
  return scale.meaning(code);
}

TEST(QualityScale, TakesTheScaleThatTheColumnShows) {
  EXPECT_EQ(second_of("Good", "Bad"), Quality::kBad);
  EXPECT_EQ(second_of("Good", "Uncertain"), Quality::kGood);
  EXPECT_EQ(second_of("192", "0"), Quality::kBad);
  EXPECT_EQ(second_of("192", "24"), Quality::kBad);
  EXPECT_EQ(second_of("192", "64"), Quality::kGood);
  EXPECT_EQ(second_of("1", "0"), Quality::kBad);
  EXPECT_EQ(second_of("100", "0"), Quality::kBad);
  EXPECT_EQ(second_of("0", "0"), Quality::kGood);
  EXPECT_EQ(second_of("2147483648", "0"), Quality::kGood);  // OPC UA
  EXPECT_EQ(second_of("0", "2147483648"), Quality::kBad);
  EXPECT_EQ(second_of("Good", ""), Quality::kGood);
}

}  // namespace
}  // namespace workbench
