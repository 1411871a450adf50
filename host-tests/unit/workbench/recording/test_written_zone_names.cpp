#include <gtest/gtest.h>

#include "workbench/recording/written_zone.hpp"

namespace workbench {
namespace {

TEST(WrittenZone, ZonesAreMinutesEastOfUtc) {
  EXPECT_EQ(zone_named("mesz"), 120);
  EXPECT_EQ(zone_named("edt"), -240);
  EXPECT_EQ(zone_named("z"), 0);
  EXPECT_EQ(zone_named("pm"), std::nullopt);
}

TEST(WrittenZone, LettersThatSeveralZonesShareAreOpen) {
  EXPECT_EQ(open_zone("cst")->means, "-06:00 or +08:00");
  for (const char* clear : {"cet", "utc", "jst", "z", ""}) {
    EXPECT_EQ(open_zone(clear), nullptr) << clear;
  }
}

TEST(WrittenZone, OpenZonesGoTogetherWithTheirOwnSummerTimeAlone) {
  const auto zone = [](const char* lower) {
    return KnownZone{zone_named(lower).value_or(-1), open_zone(lower)};
  };
  for (const auto& [a, b] : {std::pair("cst", "cst"),
                             {"cst", "cdt"},
                             {"mst", "mdt"},
                             {"gmt", "bst"},
                             {"cet", "utc"},
                             {"cst", "mdt"}}) {
    EXPECT_TRUE(go_together(zone(a), zone(b))) << a << b;
    EXPECT_TRUE(go_together(zone(b), zone(a))) << a << b;
  }
  for (const auto& [a, b] :
       {std::pair("cst", "utc"), {"cst", "est"}, {"bst", "cest"}, {"pst", "jst"}}) {
    EXPECT_FALSE(go_together(zone(a), zone(b))) << a << b;
    EXPECT_FALSE(go_together(zone(b), zone(a))) << a << b;
  }
  EXPECT_EQ(zone_text(zone("cst")), "CST (-06:00 or +08:00)");
  EXPECT_EQ(zone_text(zone("mdt")), "-06:00");
}

}  // namespace
}  // namespace workbench
