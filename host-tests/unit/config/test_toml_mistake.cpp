#include <gtest/gtest.h>

#include "config/toml_mistake.hpp"

namespace config {
namespace {

TEST(TomlMistake, NamesTheDecimalPoint) {
  EXPECT_EQ(toml_mistake("a = 1\nsample_period_s = 1,0  # s\n", 2, "odd"),
            "expected a number with a decimal point, found 1,0; write 1.0");
  EXPECT_EQ(toml_mistake("a = -12,75", 1, "odd"),
            "expected a number with a decimal point, found -12,75; write -12.75");
}

TEST(TomlMistake, NamesTheQuotes) {
  EXPECT_EQ(toml_mistake("[[loop]]\r\ntag = FIC-101\r\n", 2, "odd"),
            "expected a number, true, false, or a text in quotes, found FIC-101; write a "
            "text as \"FIC-101\"");
  EXPECT_EQ(toml_mistake("real_time = False", 1, "odd"),
            "expected true or false in small letters, found False; write it small");
}

TEST(TomlMistake, SaysWhatTheParserSaidOfAnythingElse) {
  for (const char* line : {"tag = \"FIC", "tag 5", "tag = 1,", "tag = 1,2,3", ""}) {
    EXPECT_EQ(toml_mistake(line, 1, "odd"), "expected TOML, found odd; correct the line")
        << line;
  }
  EXPECT_EQ(toml_mistake("tag = 1,0", 7, "odd"),
            "expected TOML, found odd; correct the line");
}

}  // namespace
}  // namespace config
