#include <gtest/gtest.h>

#include "workbench/model/thinned.hpp"

namespace workbench {
namespace {

TEST(Thinned, LeavesAShortRecordingAndOneThatForgetsFast) {
  EXPECT_EQ(thinning_of(4000, 100), 1U);
  EXPECT_EQ(thinning_of(100'000, 3), 1U);
}

TEST(Thinned, BringsALongRecordingToFiveThousandSamples) {
  EXPECT_EQ(thinning_of(100'000, 200), 20U);
  EXPECT_EQ(thinning_of(100'000, 40), 10U);  // four samples of its memory remain
}

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

}  // namespace
}  // namespace workbench
