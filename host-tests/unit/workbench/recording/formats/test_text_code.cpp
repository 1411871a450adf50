#include <gtest/gtest.h>

#include "workbench/recording/formats/text_code.hpp"

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

TEST(TextCode, TimesAndQualitiesTellItToo) {
  // "上午" in GBK, "午後" in Shift-JIS, "오전" in Korean; "正常" in GBK.
  EXPECT_EQ(recoded_text("Time,OP\n2026/3/17 \xC9\xCF\xCE\xE7 08:15:00,1\n"),
            "Time,OP\n2026/3/17 上午 08:15:00,1\n");
  EXPECT_EQ(recoded_text("Time,OP\n2026/3/17 \x8C\xDF\x8C\xE3 8:15:00,1\n"),
            "Time,OP\n2026/3/17 午後 8:15:00,1\n");
  EXPECT_EQ(recoded_text("2026-03-17 \xBF\xC0\xC0\xFC 08:15:00,1\n"),
            "2026-03-17 오전 08:15:00,1\n");
  EXPECT_EQ(recoded_text("Time,OP,Q\n1,2,\xD5\xFD\xB3\xA3\n"), "Time,OP,Q\n1,2,正常\n");
  EXPECT_FALSE(recoded_text("Zeit,OP,Q\n1,2,ung\xFCltig\n13-M\xE4r-26,2,gut\n"));
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
