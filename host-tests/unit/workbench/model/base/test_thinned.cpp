#include <gtest/gtest.h>

#include "workbench/model/base/thinned.hpp"

namespace workbench {
namespace {

TEST(Thinned, TakesTheMeanOfWhatActsAndTheFirstOfWhatAnswers) {
  Recording recording;
  recording.period_s = 2;
  recording.t = {0, 2, 4, 6, 8};
  recording.u = {1, 3, 5, 7, 9};
  recording.y = {10, 11, 12, 13, 14};
  recording.loads = {{"feed", "", {0, 4, 0, 8, 0}}};
  const Recording fewer = thinned(recording, 2);
  EXPECT_EQ(fewer.period_s, 4);
  EXPECT_EQ(fewer.t, (std::vector<double>{0, 4}));
  EXPECT_EQ(fewer.u, (std::vector<double>{2, 6}));
  EXPECT_EQ(fewer.y, (std::vector<double>{10, 12}));
  EXPECT_EQ(fewer.loads[0].values, (std::vector<double>{2, 4}));
  EXPECT_TRUE(fewer.sp.empty());
}

TEST(Thinned, MixesNoPieces) {
  Recording recording;
  recording.period_s = 1;
  for (int k = 0; k < 10; ++k) {
    recording.t.push_back(k);
    recording.u.push_back(k);
    recording.y.push_back(k);
  }
  recording.pieces = {{0, 5, "a", 0, false}, {5, 10, "b", 70, true}};
  const Recording fewer = thinned(recording, 2);
  EXPECT_EQ(fewer.y, (std::vector<double>{0, 2, 5, 7}));
  ASSERT_EQ(fewer.pieces.size(), 2U);
  EXPECT_EQ(fewer.pieces[1].first, 2U);
  EXPECT_EQ(fewer.pieces[1].last, 4U);
  EXPECT_EQ(fewer.pieces[1].start_s, 70);
  EXPECT_TRUE(fewer.pieces[1].judges);
}

TEST(Thinned, KeepsWhereNothingWasRecordedAndWhatIsInManual) {
  Recording recording;
  recording.period_s = 1;
  for (int k = 0; k < 12; ++k) {
    for (const Column column : {Column::t, Column::u, Column::y}) {
      recording.values(column).push_back(k);
    }
  }
  recording.resampling.gaps = {{5, 7}, {11, 12}};
  recording.manual = {{0, 2}};
  recording.begins_at_rest = true;
  const Recording fewer = thinned(recording, 4);
  ASSERT_EQ(fewer.resampling.gaps.size(), 2U);
  EXPECT_EQ(fewer.resampling.gaps[0].first, 1U);
  EXPECT_EQ(fewer.resampling.gaps[0].last, 2U);
  EXPECT_EQ(fewer.resampling.gaps[1].last, fewer.size());
  ASSERT_EQ(fewer.manual.size(), 1U);
  EXPECT_EQ(fewer.manual[0].last, 1U);
  EXPECT_TRUE(fewer.begins_at_rest);
}

}  // namespace
}  // namespace workbench
