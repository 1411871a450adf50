#include <gtest/gtest.h>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/analysis/analysis.hpp"
#include "workbench/analysis/judged_pieces.hpp"

namespace workbench {
namespace {

TEST(JudgedPieces, OfARecordingWithoutGapsAreOne) {
  const Recording recording = test::simulated({});
  const JudgedPieces judged = judged_pieces(recording);
  ASSERT_EQ(judged.pieces.size(), 1u);
  EXPECT_EQ(judged.pieces[0].size(), recording.size());
  EXPECT_TRUE(judged.notes.empty());
}

TEST(JudgedPieces, LieBetweenTheGapsAndShortOnesAreLeftOut) {
  Recording recording = test::simulated({});
  recording.resampling.gaps = {{300, 400}, {430, 500}};
  const JudgedPieces judged = judged_pieces(recording);
  ASSERT_EQ(judged.pieces.size(), 2u);
  EXPECT_EQ(judged.pieces[0].size(), 300u);
  EXPECT_EQ(judged.pieces[1].u.data(), recording.u.data() + 500);
  EXPECT_TRUE(judged.pieces[1].gaps.empty());
  ASSERT_EQ(judged.notes.size(), 2u);
  EXPECT_TRUE(judged.notes[0].starts_with("judged between the long gaps: 0 to "));
  EXPECT_TRUE(judged.notes[1].starts_with("30 samples between long gaps left out"));
}

TEST(JudgedPieces, AreJudgedAsRecordingsOfTheirOwn) {
  Recording recording = test::simulated({});
  const std::size_t middle = recording.size() / 2;
  recording.resampling.gaps = {{middle, middle + 100}};
  for (std::size_t k = middle; k < middle + 100; ++k) {
    recording.u[k] = recording.u[middle - 1];
    recording.y[k] = recording.y[middle - 1];
  }
  const Analysis analysis(recording);
  EXPECT_EQ(analysis.windows(), 2);
  EXPECT_EQ(analysis.findings()[1].recording, 0u);
  const std::vector<RecordingView> pieces = judged_pieces(recording).pieces;
  const Analysis apart(pieces);
  EXPECT_EQ(analysis.result().verdict, apart.result().verdict);
  EXPECT_EQ(analysis.pooled().nats, apart.pooled().nats);
}

}  // namespace
}  // namespace workbench
