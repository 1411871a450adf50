// Several recordings of one loop as one.
#include <gtest/gtest.h>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/model/base/joined.hpp"
#include "workbench/recording/input_error.hpp"

namespace workbench {
namespace {

Recording named_noise(const char* name, std::size_t samples, std::uint64_t seed = 1000) {
  test::SetpointLoop loop;
  loop.samples = samples;
  loop.seed = seed;
  Recording out = test::simulated(loop);
  out.name = name;
  return out;
}

TEST(Joined, LeavesASingleRecordingAsItIs) {
  const Recording one = joined({named_noise("a.csv", 100)});
  EXPECT_TRUE(one.pieces.empty());
  EXPECT_EQ(one.name, "a.csv");
}

TEST(Joined, PutsOneAfterTheOtherAndTellsThemApart) {
  Recording later = named_noise("b.csv", 80, 1001);
  for (double& t : later.t) t += 5000;
  const Recording both =
      joined({named_noise("a.csv", 100), later}, {named_noise("c.csv", 60)});
  EXPECT_EQ(both.name, "a.csv, b.csv");
  ASSERT_EQ(both.pieces.size(), 3U);
  EXPECT_EQ(both.pieces[1].first, 100U);
  EXPECT_EQ(both.pieces[1].last, 180U);
  EXPECT_EQ(both.pieces[1].recording, "b.csv");
  EXPECT_EQ(both.pieces[1].start_s, 5000);
  EXPECT_FALSE(both.pieces[1].judges);
  EXPECT_TRUE(both.pieces[2].judges);
  EXPECT_EQ(both.size(), 240U);
  EXPECT_EQ(both.y[100], later.y[0]);
  EXPECT_EQ(both.t[101] - both.t[100], 1);
  EXPECT_EQ(both.t[100] - both.t[99], 1);
}

TEST(Joined, BeginsANewPieceBehindALongGap) {
  Recording one = named_noise("a.csv", 300);
  one.resampling.gaps = {{100, 150}};
  const Recording cut = joined({one});
  ASSERT_EQ(cut.pieces.size(), 2U);
  EXPECT_EQ(cut.size(), 250U);
  EXPECT_EQ(cut.pieces[1].start_s, 150);
  EXPECT_EQ(cut.u[100], one.u[150]);
  EXPECT_FALSE(cut.resampling.notes.empty());
}

TEST(Joined, KeepsOnlyTheLongestOfManyGaps) {
  Recording one = named_noise("a.csv", 3000);
  for (std::size_t k = 100; k < 2900; k += 100) {
    one.resampling.gaps.push_back({k, k + 10 + k / 100});
  }
  const Recording cut = joined({one});
  EXPECT_EQ(cut.pieces.size(), 12U);
  EXPECT_EQ(cut.pieces.back().recording, "a.csv");
  EXPECT_EQ(cut.pieces.back().last, cut.size());
}

// What joined() cuts out stays in its place and is left out.
TEST(Parts, BeginAnewBehindALongGapAndLeaveItOut) {
  Recording one = named_noise("a.csv", 200);
  EXPECT_EQ(parts_of(one).pieces.size(), 1U);
  EXPECT_TRUE(parts_of(one).left_out.empty());
  one.resampling.gaps = {{80, 120}};
  one.left_out = {{110, 130}, {150, 160}};
  const Parts parts = parts_of(one);
  ASSERT_EQ(parts.pieces.size(), 2U);
  EXPECT_EQ(parts.pieces[0].first, 0U);
  EXPECT_EQ(parts.pieces[0].last, 120U);
  EXPECT_EQ(parts.pieces[1].first, 120U);
  EXPECT_EQ(parts.pieces[1].last, 200U);
  EXPECT_EQ(parts.pieces[1].start_s, one.t[120]);
  ASSERT_EQ(parts.left_out.size(), 2U);
  EXPECT_EQ(parts.left_out[0].first, 80U);
  EXPECT_EQ(parts.left_out[0].last, 130U);
  EXPECT_EQ(parts.left_out[1].first, 150U);
}

TEST(Joined, BringsAFasterRecordingDownToTheSlowerOne) {
  Recording fast = named_noise("fast.csv", 400);
  fast.period_s = 0.5;
  const Recording both = joined({named_noise("slow.csv", 100), fast});
  EXPECT_EQ(both.period_s, 1);
  EXPECT_EQ(both.pieces[1].last, 300U);
  EXPECT_EQ(both.u[100], (fast.u[0] + fast.u[1]) / 2);
  fast.period_s = 0.7;
  EXPECT_THROW((void)joined({named_noise("slow.csv", 100), fast}), InputError);
}

TEST(Joined, RefusesOtherUnitsAndNamesBothFiles) {
  Recording percent = named_noise("percent.csv", 100);
  percent.units[static_cast<std::size_t>(Column::y)] = "%";
  Recording litres = named_noise("litres.csv", 100, 1001);
  EXPECT_NO_THROW((void)joined({percent, litres}));  // one says none
  litres.units[static_cast<std::size_t>(Column::y)] = "l/s";
  for (const bool judges : {false, true}) {
    try {
      (void)(judges ? joined({percent}, {litres}) : joined({percent, litres}));
      FAIL() << "taken together";
    } catch (const InputError& error) {
      const std::string text = error.what();
      for (const char* part : {"percent.csv", "litres.csv", "'%'", "'l/s'"}) {
        EXPECT_NE(text.find(part), std::string::npos) << text;
      }
    }
  }
}

TEST(Joined, KeepsWhatAllHave) {
  Recording one = named_noise("a.csv", 100);
  one.loads = {{"feed", "", one.y}, {"steam", "", one.y}};
  Recording two = named_noise("b.csv", 100, 1001);
  two.loads = {{"steam", "", two.y}};
  two.sp.clear();
  const Recording both = joined({one, two});
  EXPECT_FALSE(both.has(Column::sp));
  EXPECT_TRUE(both.has(Column::x));
  ASSERT_EQ(both.loads.size(), 1U);
  EXPECT_EQ(both.loads[0].values, both.y);
}

TEST(Joined, ATooSlowCompanionIsRefused) {
  Recording fast = named_noise("fast.csv", 400);
  Recording slow = named_noise("slow.csv", 400);
  slow.period_s = 100 * fast.period_s;
  try {
    static_cast<void>(joined({fast}, {slow}));
    FAIL();
  } catch (const CannotAnswer& error) {
    EXPECT_EQ(error.file, "fast.csv");
    EXPECT_NE(error.expected.find("60 samples"), std::string::npos);
  }
}

TEST(CutTo, TakesGapsAlong) {
  Recording recording = named_noise("a.csv", 100);
  recording.resampling.gaps = {{10, 20}, {60, 80}};
  const Recording cut = cut_to(recording, {{50, 70, "a.csv", 0, false}});
  ASSERT_EQ(cut.resampling.gaps.size(), 1U);
  EXPECT_EQ(cut.resampling.gaps[0].first, 10U);
  EXPECT_EQ(cut.resampling.gaps[0].last, 20U);
}

}  // namespace
}  // namespace workbench
