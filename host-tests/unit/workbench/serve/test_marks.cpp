// Stretches to beware of.
#include <gtest/gtest.h>

#include <cmath>

#include "workbench/serve/marks.hpp"

namespace workbench {
namespace {

Recording moving(std::size_t samples) {
  Recording out;
  out.period_s = 2;
  for (std::size_t k = 0; k < samples; ++k) {
    out.t.push_back(2.0 * static_cast<double>(k));
    out.u.push_back(std::sin(0.1 * static_cast<double>(k)));
    out.y.push_back(std::cos(0.1 * static_cast<double>(k)));
  }
  return out;
}

std::vector<Mark> all_but_steps(const Recording& recording) {
  std::vector<Mark> out = marks_of(recording);
  std::erase_if(out, [](const Mark& mark) { return mark.kind == Mark::Kind::kStep; });
  return out;
}

TEST(ServeMarks, FindNothingInSignalsThatMove) {
  EXPECT_TRUE(marks_of(moving(500)).empty());
}

TEST(ServeMarks, FindWhereURestsAtItsLimit) {
  Recording recording = moving(500);
  for (std::size_t k = 100; k < 140; ++k) recording.u[k] = 2;
  for (std::size_t k = 200; k < 240; ++k) recording.u[k] = 0.5;
  const std::vector<Mark> marks = all_but_steps(recording);
  ASSERT_EQ(marks.size(), 2U);
  EXPECT_EQ(marks[1].kind, Mark::Kind::kRest);
  EXPECT_EQ(marks[0].kind, Mark::Kind::kLimit);
  EXPECT_EQ(marks[0].from_s, 200);
  EXPECT_EQ(marks[0].to_s, 278);
}

TEST(ServeMarks, FindWhereYIsHeldButNotWhereItIsCoarse) {
  Recording recording = moving(500);
  for (std::size_t k = 300; k < 340; ++k) recording.y[k] = 0.25;
  ASSERT_EQ(marks_of(recording).size(), 1U);
  EXPECT_EQ(marks_of(recording)[0].kind, Mark::Kind::kHeld);
  for (double& value : recording.y) value = std::round(value);
  EXPECT_TRUE(marks_of(recording).empty());
}

TEST(ServeMarks, FindStraightLinesBetweenStoredPoints) {
  Recording recording = moving(500);
  for (std::size_t k = 100; k < 160; ++k) {
    recording.y[k] = 0.5 + 0.001 * static_cast<double>(k);
  }
  const std::vector<Mark> marks = marks_of(recording);
  ASSERT_EQ(marks.size(), 1U);
  EXPECT_EQ(marks[0].kind, Mark::Kind::kStraight);
  EXPECT_EQ(marks[0].from_s, 200);
  EXPECT_EQ(marks[0].to_s, 318);
}

TEST(ServeMarks, StandInTheOrderOfTimeAndAreBounded) {
  Recording recording = moving(20000);
  for (std::size_t k = 0; k + 20 < recording.size(); k += 40) {
    for (std::size_t i = 0; i < 15; ++i) recording.u[k + i] = 2;
  }
  const std::vector<Mark> marks = marks_of(recording);
  EXPECT_EQ(marks.size(), kMostMarks);
  for (std::size_t i = 1; i < marks.size(); ++i) {
    EXPECT_GE(marks[i].from_s, marks[i - 1].from_s);
  }
}

TEST(ServeMarks, FindWhereUJumpsButNotWhereItOnlyMoves) {
  Recording recording = moving(500);
  for (std::size_t k = 200; k < 500; ++k) recording.u[k] += 3;
  const std::vector<Mark> marks = marks_of(recording);
  ASSERT_EQ(marks.size(), 1U);
  EXPECT_EQ(marks[0].kind, Mark::Kind::kStep);
  EXPECT_EQ(marks[0].from_s, 398);
  EXPECT_EQ(marks[0].to_s, 400);
}

TEST(ServeMarks, FindGaps) {
  Recording recording = moving(500);
  recording.resampling.gaps = {{50, 71}, {480, 500}};
  const std::vector<Mark> marks = marks_of(recording);
  ASSERT_EQ(marks.size(), 2U);
  EXPECT_EQ(marks[0].kind, Mark::Kind::kGap);
  EXPECT_EQ(marks[0].to_s, 140);
  EXPECT_EQ(marks[1].to_s, 998);
}

TEST(ServeMarks, HaveNames) {
  EXPECT_EQ(name_of(Mark::Kind::kLimit), "limit");
  EXPECT_EQ(name_of(Mark::Kind::kRest), "rest");
  EXPECT_EQ(name_of(Mark::Kind::kHeld), "held");
  EXPECT_EQ(name_of(Mark::Kind::kStraight), "straight");
  EXPECT_EQ(name_of(Mark::Kind::kStep), "step");
  EXPECT_EQ(name_of(Mark::Kind::kGap), "gap");
}

}  // namespace
}  // namespace workbench
