#include <gtest/gtest.h>

#include <cmath>

#include "workbench/screen/screened_loop.hpp"

namespace workbench {
namespace {

ScreenedLoop loop_example() {
  ScreenedLoop loop;
  loop.loop = "FIC-101";
  loop.files = {"a.csv"};
  loop.verdict = "stiction";
  loop.stick_band = {{true, 5, 4.5, 5.5}, {true, 6, 5.5, 6.5}};
  loop.span = 20;
  loop.detectable_band = 1;
  loop.nats = 80;
  loop.stem_nats = std::nan("");
  loop.period_s = 30;
  loop.trend = {{"2026-03", "stiction", 40, 5, 1}, {"2026-04", "undecided", 3, NAN, 0.5}};
  loop.rhythm = {30, 1000, 1, "", "CST", {0, 1, 0.5F}, {2, 4, 3}};
  loop.picture_u = "!~P";
  return loop;
}

TEST(ScreenedLoop, TheLineHasTheContractsFields) {
  const nlohmann::ordered_json json = json_of(loop_example());
  EXPECT_EQ(json["loop"], "FIC-101");
  EXPECT_EQ(json["stick_band"]["ascending"]["value"], 5);
  EXPECT_EQ(json["detectable_band"]["percent_of_span"], 5);
  EXPECT_EQ(json["evidence"]["nats"], 80);
  EXPECT_TRUE(json["evidence"]["stem_nats"].is_null());
  EXPECT_TRUE(json["group"].is_null());
  EXPECT_FALSE(json["leads"]);
  EXPECT_TRUE(json["error"].is_null());
}

TEST(ScreenedLoop, AnErrorHasNoNumbers) {
  ScreenedLoop loop;
  loop.loop = "x";
  loop.error = "expected a table";
  const nlohmann::ordered_json json = json_of(loop);
  for (const char* name : {"verdict", "oscillating_share", "cost", "samples"}) {
    EXPECT_TRUE(json[name].is_null()) << name;
  }
  EXPECT_EQ(json["error"], "expected a table");
}

TEST(ScreenedLoop, TheJournalKeepsAllOfIt) {
  const ScreenedLoop loop = loop_example();
  const ScreenedLoop back =
      from_journal(nlohmann::json::parse(journal_json(loop).dump()));
  EXPECT_EQ(json_of(back), json_of(loop));
  EXPECT_EQ(back.picture_u, loop.picture_u);
  // Signals keep their shape; scale and offset do not matter to groups.
  EXPECT_EQ(back.rhythm.zone, "CST");
  ASSERT_EQ(back.rhythm.y.size(), 3U);
  EXPECT_NEAR(back.rhythm.y[2], 0.5F, 1e-3F);
  EXPECT_EQ(journal_json(back), journal_json(from_journal(journal_json(back))));
}

TEST(PictureOf, RunsFromLowToHigh) {
  EXPECT_EQ(picture_of({5, 0, 2, 1}, 1), "!~P");
  EXPECT_EQ(picture_of({3, 3, 3}, 0), "");
  EXPECT_EQ(picture_of(std::vector<double>{}, 0), "");
}

}  // namespace
}  // namespace workbench
