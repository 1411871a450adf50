#include <gtest/gtest.h>

#include "workbench/analysis/votes.hpp"

namespace workbench {
namespace {

using V = ident::Verdict;

Votes votes(int sticking, int playing, int healthy, int open) {
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

TEST(Votes, AreListed) {
  EXPECT_EQ(listed(votes(3, 0, 1, 2)), " 3 stiction, 1 no stiction, 2 undecided");
  EXPECT_EQ(listed({}), "");
}

}  // namespace
}  // namespace workbench
