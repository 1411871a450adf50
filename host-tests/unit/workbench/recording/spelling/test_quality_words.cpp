#include <gtest/gtest.h>

#include "workbench/recording/spelling/quality_words.hpp"

namespace workbench {
namespace {

TEST(QualityWords, NamesOfQualityColumns) {
  for (const char* key : {"quality", "status", "isgood", "valid", "bad", "error",
                          "qualit\xC3\xA9", "ステータス"}) {
    EXPECT_TRUE(is_quality_name(key)) << key;
  }
  for (const char* key :
       {"dataquality", "opcqualitycode", "pointstatus", "valuestatus"}) {
    EXPECT_TRUE(is_quality_name(key)) << key;
  }
  for (const char* key : {"pv", "pumpstatus", "equality1"}) {
    EXPECT_FALSE(is_quality_name(key)) << key;
  }
  EXPECT_TRUE(is_sure_quality_name("dataquality"));
  EXPECT_FALSE(is_sure_quality_name("airquality"));
  EXPECT_FALSE(is_sure_quality_name("q"));
  EXPECT_TRUE(marks_bad({"f1", "pv", "isbad"}));
  EXPECT_FALSE(marks_bad({"bad", "quality"}));
  EXPECT_FALSE(marks_bad({}));
}

TEST(QualityWords, WordsInSeveralLanguages) {
  for (const char* word : {"good", "bonne", "正常", "nr", "ja", "ok"}) {
    EXPECT_EQ(quality_word(word), QualityWord::kGood) << word;
  }
  for (const char* word : {"mauvaise", "異常", "iop", "nein", "false", "b"}) {
    EXPECT_EQ(quality_word(word), QualityWord::kBad) << word;
  }
  EXPECT_EQ(quality_word("questionable"), QualityWord::kUncertain);
  EXPECT_EQ(quality_word("green"), QualityWord::kUnknown);
}

TEST(QualityWords, Yes) {
  EXPECT_TRUE(says_yes("true"));
  EXPECT_FALSE(says_yes("false"));
}

TEST(QualityWords, InAnyCaseAndWithoutMarks) {
  EXPECT_EQ(quality_word("Хорошее"), QualityWord::kGood);
  EXPECT_EQ(quality_word("GÜLTIG"), QualityWord::kGood);
  EXPECT_EQ(quality_word("Válido"), QualityWord::kGood);
  EXPECT_EQ(quality_word("Não"), QualityWord::kBad);
}

TEST(QualityWords, BehindANumber) {
  const auto good = number_with_quality("45.2 G");
  ASSERT_TRUE(good);
  EXPECT_EQ(good->number, "45.2");
  EXPECT_EQ(good->word, QualityWord::kGood);
  EXPECT_EQ(number_with_quality("45,2 (Good)")->word, QualityWord::kGood);
  EXPECT_EQ(number_with_quality("45.2 (?)")->word, QualityWord::kUncertain);
  EXPECT_EQ(number_with_quality("0.0 B")->word, QualityWord::kBad);
  for (const char* cell : {"45.2", "45.2 m3/h", "1 234", "", " G", "45.2 xyz"}) {
    EXPECT_FALSE(number_with_quality(cell)) << cell;
  }
}

TEST(QualityWords, OfBuildingSystems) {
  for (const char* word : {"{fault}", "{down}", "NOK", "Fault", "{stale}", "{null}",
                           "{disabled}", "{fault,down}", "{alarm,stale}", "{down} @ 8"}) {
    EXPECT_EQ(quality_word(word), QualityWord::kBad) << word;
  }
  for (const char* word :
       {"{ok}", "{ }", "{alarm}", "{overridden}", "{alarm,unackedAlarm}", "{ok} @ def"}) {
    EXPECT_EQ(quality_word(word), QualityWord::kGood) << word;
  }
  EXPECT_EQ(quality_word("{alarm,xyz}"), QualityWord::kUnknown);
  EXPECT_TRUE(is_quality_name("trendflags"));
  EXPECT_TRUE(is_quality_name("statusflags"));
}

TEST(QualityWords, NumbersThatAreCodes) {
  for (const double code : {0., 1., 64., 100., 192., 500., 2147483648., -2147483132.}) {
    EXPECT_TRUE(is_quality_code(code)) << code;
  }
  for (const double flow : {0.5, 37., 120., 191.9, 260.3, 1500.}) {
    EXPECT_FALSE(is_quality_code(flow)) << flow;
  }
}

}  // namespace
}  // namespace workbench
