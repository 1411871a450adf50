#include <gtest/gtest.h>

#include "workbench/recording/text_code.hpp"

namespace workbench {
namespace {

using namespace std::string_literals;

TEST(TextCode, IsTheOneThatMakesWords) {
  // "Время,Выход", "操作量", "Wartość zadana", "Çıkış"
  EXPECT_EQ(recoded_text("\xC2\xF0\xE5\xEC\xFF,\xC2\xFB\xF5\xEE\xE4\n"), "Время,Выход\n");
  EXPECT_EQ(recoded_text("\x91\x80\x8D\xEC\x97\xCA,PV\n"), "操作量,PV\n");
  EXPECT_EQ(recoded_text("Warto\x9C\xE6 zadana\n"), "Wartość zadana\n");
  EXPECT_EQ(recoded_text("\xC7\xFD\x6B\xFD\xFE\n"), "Çıkış\n");
}

TEST(TextCode, Windows1252NeedsNoOther) {
  EXPECT_FALSE(recoded_text("Stellgr\xF6\xDF"s + "e,m\xB3/h\n"));
  EXPECT_FALSE(recoded_text("\xE4\xE4\xE4,\xF6\n"));
}

TEST(TextCode, NorDoesUtf8) {
  EXPECT_FALSE(recoded_text("操作量,PV\n"));
  EXPECT_FALSE(recoded_text("t,u,y\n"));
  EXPECT_FALSE(recoded_text(""));
}

TEST(TextCode, WhatTheCodeLacksIsMarked) {
  const std::string head = "\xC2\xF0\xE5\xEC\xFF,PV\n";
  const std::string rows(70000, '1');
  EXPECT_EQ(recoded_text(head + rows + "\n\x98\n"),
            "Время,PV\n" + rows + "\n\xEF\xBF\xBD\n");
}

}  // namespace
}  // namespace workbench
