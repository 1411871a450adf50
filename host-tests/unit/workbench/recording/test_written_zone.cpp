#include <gtest/gtest.h>

#include "workbench/recording/written_zone.hpp"

namespace workbench {
namespace {

TEST(WrittenZone, KnownOnes) {
  for (const char* text : {"+02:00", "+0200", "CEST", "GMT+0200", "+02:00[Europe/Berlin]",
                           "GMT+0200 (Central European Summer Time)", "EET"}) {
    const auto zone = written_zone(text);
    ASSERT_TRUE(zone) << text;
    EXPECT_EQ(zone->minutes, 120) << text;
    EXPECT_EQ(zone->length, std::string_view(text).size()) << text;
  }
  EXPECT_EQ(written_zone("Z[UTC]")->minutes, 0);
  EXPECT_EQ(written_zone("-0330")->minutes, -210);
}

TEST(WrittenZone, UnknownOnesKeepTheirName) {
  for (const char* text : {"IST", "AST", "Europe/Berlin", "America/New_York"}) {
    const auto zone = written_zone(text);
    ASSERT_TRUE(zone) << text;
    EXPECT_FALSE(zone->minutes) << text;
    EXPECT_EQ(zone->unknown, text);
  }
}

TEST(WrittenZone, NoneAndWrongOnes) {
  EXPECT_EQ(written_zone("")->length, 0U);
  EXPECT_EQ(written_zone(" 2026")->length, 0U);
  for (const char* text : {"good", "Uhr", "TOOLONG", "+15:00", "+x"}) {
    EXPECT_FALSE(written_zone(text)) << text;
  }
}

TEST(WrittenZone, AnOffsetSaysWhichOfOpenLettersIsMeant) {
  EXPECT_NE(written_zone("CST")->open, nullptr);
  EXPECT_EQ(written_zone("CST")->minutes, -360);
  EXPECT_EQ(written_zone("CST+08:00")->minutes, 480);
  EXPECT_EQ(written_zone("CST+08:00")->open, nullptr);
  EXPECT_EQ(written_zone("GMT+0200")->minutes, 120);
}

TEST(WrittenZone, TimesMayBeComparedWhereBothAreSure) {
  EXPECT_TRUE(one_clock("", ""));
  EXPECT_TRUE(one_clock("IST", "IST"));
  EXPECT_TRUE(one_clock("+01:00", "+05:30"));
  EXPECT_TRUE(one_clock("CST", "CDT"));
  EXPECT_TRUE(one_clock("-06:00", "CST"));
  EXPECT_FALSE(one_clock("CST", "+08:00"));
  EXPECT_FALSE(one_clock("CST", "EST"));
  EXPECT_FALSE(one_clock("IST", "+05:30"));
  EXPECT_FALSE(one_clock("IST", "AST"));
  EXPECT_FALSE(one_clock("", "+00:00"));
  EXPECT_FALSE(one_clock("", "CST"));
}

TEST(WrittenZone, InWordsSaysWhatItMayMean) {
  EXPECT_EQ(zone_words("CST"), "CST (-06:00 or +08:00)");
  EXPECT_EQ(zone_words("+05:30"), "+05:30");
  EXPECT_EQ(zone_words("IST"), "IST (not known)");
  EXPECT_EQ(zone_words(""), "no zone");
}

}  // namespace
}  // namespace workbench
