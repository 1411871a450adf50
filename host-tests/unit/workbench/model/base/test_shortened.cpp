#include <gtest/gtest.h>

#include <cmath>

#include "workbench/model/base/shortened.hpp"

namespace workbench {
namespace {

// u and y swing once in `cycle` samples, most of all around sample `lively`.
Recording swinging(std::size_t samples, double cycle, double lively) {
  Recording recording;
  recording.name = "loop.csv";
  recording.period_s = 2;
  for (std::size_t k = 0; k < samples; ++k) {
    const auto at = static_cast<double>(k);
    const double size = 1 + 3 * std::exp(-std::pow((at - lively) / 3000, 2));
    recording.t.push_back(10 + 2 * at);
    recording.u.push_back(50 + size * std::sin(6.283 * at / cycle));
    recording.y.push_back(20 + size * std::cos(6.283 * at / cycle));
  }
  return recording;
}

TEST(Shortened, LeavesAShortRecording) {
  EXPECT_FALSE(is_long(swinging(5000, 50, 0)));
  EXPECT_TRUE(is_long(swinging(5001, 50, 0)));
}

TEST(Shortened, TakesSamplesTogetherWhereNothingMovesWithinThem) {
  const Shortened fewer = shortened(swinging(40'000, 2000, 0), Column::y);
  EXPECT_EQ(fewer.count, 8U);
  EXPECT_FALSE(fewer.is_excerpt);
  EXPECT_EQ(fewer.recording.size(), 5000U);
  EXPECT_EQ(fewer.in_whole(700), 700);
  EXPECT_EQ(fewer.in_short(700), 700);
}

TEST(Shortened, CutsWhatMovesFastToItsLiveliestStretch) {
  const Recording whole = swinging(40'000, 20, 30'000);
  const Shortened fewer = shortened(whole, Column::y);
  EXPECT_EQ(fewer.count, 1U);
  EXPECT_TRUE(fewer.is_excerpt);
  ASSERT_EQ(fewer.recording.size(), 5000U);
  EXPECT_TRUE(fewer.recording.pieces.empty());
  const double later_s = fewer.in_whole(0);
  EXPECT_NEAR(later_s, 2 * 27'500, 2 * 100);
  EXPECT_EQ(fewer.recording.t.front(), 10 + later_s);
  EXPECT_EQ(fewer.recording.u[7], whole.u[static_cast<std::size_t>(later_s / 2) + 7]);
  EXPECT_EQ(fewer.in_short(later_s + 30), 30);
  EXPECT_EQ(fewer.in_short(0), 0);
  EXPECT_EQ(fewer.in_short(80'000), 10'000);
}

TEST(Shortened, KeepsItsShareOfEachPiece) {
  Recording whole = swinging(40'000, 20, 5000);
  whole.pieces = {{0, 10'000, "a", 0, false}, {10'000, 40'000, "b", 70, true}};
  whole.left_out = {{4000, 4100}, {39'990, 40'000}};
  const Shortened fewer = shortened(whole, Column::y);
  ASSERT_EQ(fewer.recording.pieces.size(), 2U);
  const Piece& a = fewer.recording.pieces[0];
  const Piece& b = fewer.recording.pieces[1];
  EXPECT_EQ(a.last, 1250U);
  EXPECT_EQ(b.first, 1250U);
  EXPECT_EQ(b.last, 5000U);
  EXPECT_TRUE(b.judges);
  EXPECT_EQ(b.recording, "b");
  // Time in the file and time in the whole recording move alike.
  EXPECT_EQ(fewer.in_whole(2 * 1250.0), 20'000 + (b.start_s - 70));
  EXPECT_EQ(fewer.in_short(fewer.in_whole(6000)), 6000);
  for (const SampleRange& gone : fewer.recording.left_out) {
    EXPECT_LE(gone.last, fewer.recording.size());
  }
}

}  // namespace
}  // namespace workbench
