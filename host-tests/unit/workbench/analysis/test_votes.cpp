#include <gtest/gtest.h>

#include "workbench/analysis/votes.hpp"

namespace workbench {
namespace {

using V = ident::Verdict;

Votes votes(double sticking, double playing, double healthy, double open) {
  Votes out{};
  out[static_cast<int>(V::kStiction)] = sticking;
  out[static_cast<int>(V::kBacklash)] = playing;
  out[static_cast<int>(V::kNoStiction)] = healthy;
  out[static_cast<int>(V::kUndecided)] = open;
  return out;
}

TEST(Votes, AFaultStandsWhereMoreSaySoThanTheOpposite) {
  EXPECT_EQ(majority_of(votes(2, 0, 1, 0)), V::kStiction);
  EXPECT_EQ(majority_of(votes(1, 2, 2, 0)), V::kBacklash);
  EXPECT_EQ(majority_of(votes(0, 1, 2, 0)), V::kNoStiction);
}

TEST(Votes, TooFewOrAsManyOnEachSideLeaveItOpen) {
  EXPECT_EQ(majority_of(votes(1, 0, 0, 4)), V::kUndecided);
  EXPECT_EQ(majority_of(votes(1, 1, 2, 0)), V::kUndecided);
}

TEST(Votes, NoFaultIsSaidWhereHalfOfTheTimeSaysSo) {
  EXPECT_EQ(majority_of(votes(0, 0, 2, 2)), V::kNoStiction);
  EXPECT_EQ(majority_of(votes(0, 0, 469, 1091)), V::kUndecided);
  EXPECT_EQ(majority_of(votes(469, 0, 0, 1091)), V::kStiction);
}

TEST(Votes, CountByTheLengthOfTheirWindows) {
  EXPECT_EQ(majority_of(votes(700, 0, 450, 260)), V::kStiction);
  EXPECT_EQ(majority_of(votes(0, 0, 40, 190)), V::kUndecided);
}

TEST(Votes, AreListed) {
  VoteCounts counts{};
  counts[static_cast<int>(V::kStiction)] = 3;
  counts[static_cast<int>(V::kNoStiction)] = 1;
  counts[static_cast<int>(V::kUndecided)] = 2;
  EXPECT_EQ(listed(counts), " 3 stiction, 1 no stiction, 2 undecided");
  EXPECT_EQ(listed({}), "");
}

}  // namespace
}  // namespace workbench
