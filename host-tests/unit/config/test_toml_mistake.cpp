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

TEST(TomlMistake, NamesWhatStandsTwiceAndWhere) {
  const char* text = "[[loop]]\nu = { }\n[[loop]]\nid = 2\nu = { }\nusual = 1\nu = { }\n";
  EXPECT_EQ(toml_mistake(text, 7,
                         "Error while parsing key-value pair: cannot redefine existing "
                         "table 'u'"),
            "expected u once, found it twice, first in line 5; remove one");
  EXPECT_EQ(toml_mistake("[gateway]\nname = \"a\"\n [gateway]\n", 3,
                         "Error while parsing table header: cannot redefine existing "
                         "table 'gateway'"),
            "expected gateway once, found it twice, first in line 1; remove one");
  EXPECT_EQ(toml_mistake("[[loop]]\nu = { a = 1, a = 2 }\n", 2,
                         "Error while parsing key-value pair: cannot redefine existing "
                         "integer 'a'"),
            "expected a once, found it twice; remove one");
  EXPECT_EQ(toml_mistake("[loop]\nid = 1\n[[loop]]\n", 3,
                         "Error while parsing table header: cannot redefine existing "
                         "table 'loop' as array-of-tables"),
            "expected [[loop]] for each of its tables, found [loop], first in line 1; "
            "write [[loop]] there, too");
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
