#include <gtest/gtest.h>

#include <string>

#include "workbench/recording/spelling/bad_value.hpp"

namespace workbench {
namespace {

TEST(BadValue, WordsOfHistoriansAreGapsInEveryFile) {
  for (const std::string cell :
       {"Bad",        "BAD INPUT", "No Data", "I/O Timeout", "Digital State 246",
        "Pt Created", "#N/A",      "#DIV/0!", "#NV",         "null",
        "---",        "+++++++",   "-------", "******",      "?????",
        "##",         "OL",        "-OL",     "Comm Fail",   "<Null>",
        "ungültig"}) {
    EXPECT_TRUE(says_no_value(cell, false)) << cell;
  }
}

TEST(BadValue, NaNIsAGapInExportsOnly) {
  for (const std::string cell :
       {"NaN", "nan", "1.#QNAN", "-1.#IND", "-1.#IND00", "1.#QNAN0", "-"}) {
    EXPECT_TRUE(says_no_value(cell, true)) << cell;
    EXPECT_FALSE(says_no_value(cell, false)) << cell;
  }
}

TEST(BadValue, TypingMistakesAndInfinitiesAreNone) {
  for (const std::string cell : {"abc", "12..3", "1O", "inf", "", "oops", "#", "1.#INF",
                                 "1.#QNAN1", "++", "+-+", "+++5"}) {
    EXPECT_FALSE(says_no_value(cell, true)) << cell;
  }
}

TEST(BadValue, OtherWordsMayStandAmongNumbers) {
  for (const std::string cell :
       {"Questionable", "<Invalid>", "(null)", "Archive Offline", "+OVER", "-OVER", "abc",
        "[-11059] No Good Data For Calculation", "n. def.", "45.2 (Bad)", "<45.2", "inf",
        "+INF", "-Infinity", "-1.#INF", "1.#INF00", "OFF"}) {
    EXPECT_TRUE(reads_as_word(cell)) << cell;
  }
  for (const std::string cell :
       {"12..3", "1O", "l.5", "45.2*", "45.2 S", "<45.2x", "1.#INF5", "infx", "nan",
        "TRUE", "On", "B", "", "-", "+"}) {
    EXPECT_FALSE(reads_as_word(cell)) << cell;
  }
  EXPECT_TRUE(says_no_value("#####", false));
  EXPECT_TRUE(says_no_value("@@@@", false));
}

TEST(BadValue, BeyondWhatIsMeasured) {
  for (const std::string cell : {"<600", ">95 %", ">= 0.5", "<1.234,5"}) {
    EXPECT_TRUE(is_beyond(cell)) << cell;
  }
  for (const std::string cell : {"<", "<NA>", "600", "", "<Bad>"}) {
    EXPECT_FALSE(is_beyond(cell)) << cell;
  }
  EXPECT_TRUE(says_no_value("<NA>", true));
}

Quality second_of(const std::string& other, const std::string& cell) {
  QualityScale scale;
  static_cast<void>(scale.add(other));
  const double code = scale.add(cell);
  return scale.meaning(code);
}

TEST(QualityScale, TakesTheScaleThatTheColumnShows) {
  EXPECT_EQ(second_of("Good", "Bad"), Quality::kBad);
  EXPECT_EQ(second_of("Good", "Uncertain"), Quality::kUncertain);
  EXPECT_EQ(second_of("192", "0"), Quality::kBad);
  EXPECT_EQ(second_of("192", "24"), Quality::kBad);
  EXPECT_EQ(second_of("192", "64"), Quality::kUncertain);
  EXPECT_EQ(second_of("1", "0"), Quality::kBad);
  EXPECT_EQ(second_of("100", "0"), Quality::kBad);
  EXPECT_EQ(second_of("0", "0"), Quality::kGood);
  EXPECT_EQ(second_of("2147483648", "0"), Quality::kGood);  // OPC UA
  EXPECT_EQ(second_of("0", "2147483648"), Quality::kBad);
  EXPECT_EQ(second_of("Good", ""), Quality::kGood);
  EXPECT_EQ(second_of("0x00000000", "0x80000000"), Quality::kBad);
  EXPECT_EQ(second_of("0x80000000", "0x40000000"), Quality::kUncertain);
}

TEST(QualityScale, KnowsLettersAndCountsWhatItDoesNotKnow) {
  for (const char* bad : {"B", "Poor", "F_BadX", "False"}) {
    const bool known = std::string(bad) != "F_BadX";
    EXPECT_EQ(second_of("G", bad), known ? Quality::kBad : Quality::kGood) << bad;
  }
  QualityScale scale;
  for (const char* cell : {"Good", "G", "P", "P", ""}) {
    EXPECT_EQ(scale.meaning(scale.add(cell)), Quality::kGood) << cell;
  }
  for (const char* cell : {"U", "QUES", "?"}) {
    EXPECT_EQ(scale.meaning(scale.add(cell)), Quality::kUncertain) << cell;
  }
  EXPECT_EQ(scale.unknown().list(), "'P' 2");
}

TEST(QualityScale, OfAColumnThatMarksWhatIsBad) {
  for (const auto& [no, yes] : {std::pair("0", "1"), std::pair("False", "True")}) {
    QualityScale scale(true);
    const double good = scale.add(no);
    const double bad = scale.add(yes);
    EXPECT_EQ(scale.meaning(good), Quality::kGood) << no;
    EXPECT_EQ(scale.meaning(bad), Quality::kBad) << yes;
  }
  QualityScale deviation(true);  // a column Error that is the control error
  const double one = deviation.add("1");
  static_cast<void>(deviation.add("0.3"));
  EXPECT_EQ(deviation.meaning(one), Quality::kGood);
}

TEST(QualityScale, ZeroIsGoodWhereNearlyAllAreZeros) {
  QualityScale scale;
  for (int i = 0; i < 9; ++i) static_cast<void>(scale.add("0"));
  const double other = scale.add("1");
  EXPECT_EQ(scale.meaning(0), Quality::kGood);
  EXPECT_EQ(scale.meaning(other), Quality::kBad);
  static_cast<void>(scale.add("1"));
  EXPECT_EQ(scale.meaning(0), Quality::kBad);
  EXPECT_EQ(scale.meaning(other), Quality::kGood);
}

TEST(QualityScale, KnowsTheCodesOfIgnition) {
  for (const char* bad : {"0", "500", "600", "-2147483132"}) {
    EXPECT_EQ(second_of("192", bad), Quality::kBad) << bad;
  }
  for (const char* good : {"192", "216", "448"}) {
    EXPECT_EQ(second_of("192", good), Quality::kGood) << good;
  }
  EXPECT_EQ(second_of("192", "64"), Quality::kUncertain);
}

TEST(QualityScale, KnowsSignedCodesOfOpcUa) {
  EXPECT_EQ(second_of("0", "-2147155968"), Quality::kBad);
  QualityScale scale;
  const double good = scale.add("0");
  static_cast<void>(scale.add("-2147155968"));
  EXPECT_EQ(scale.meaning(good), Quality::kGood);
}

TEST(BadValue, WordsOfStatisticsPrograms) {
  for (const char* cell : {"NA", "\\N", "ND", "N.D.", "N/D", "n.c.", "s/d"}) {
    EXPECT_TRUE(says_no_value(cell, false)) << cell;
  }
  EXPECT_TRUE(says_no_value(".", true));
  EXPECT_FALSE(says_no_value(".", false));
}

}  // namespace
}  // namespace workbench
