#include <gtest/gtest.h>

#include "workbench/recording/option_words.hpp"

namespace workbench {
namespace {

TEST(OptionWords, AreThoseThatWereGiven) {
  RecordingSource source;
  EXPECT_EQ(option_words(source), "");
  source.names.u = "Out %";
  source.names.loads = {"feed"};
  source.ts = 0.015;
  source.date_order = DateOrder::mdy;
  source.decimal = ',';
  source.u_before = 0;
  EXPECT_EQ(option_words(source),
            " --u \"Out %\" --load feed --date-order mdy --decimal comma --ts 0.015 "
            "--u-before 0");
  RecordingSource log;
  log.config = "g.toml";
  log.loop = 2;
  EXPECT_EQ(option_words(log), " --config g.toml --loop 2");
}

TEST(OptionWords, AFileIsNoOption) {
  EXPECT_EQ(file_word("-a.csv"), "./-a.csv");
  EXPECT_EQ(file_word("my loop.csv"), "\"my loop.csv\"");
}

}  // namespace
}  // namespace workbench
