#include <gtest/gtest.h>

#include <cmath>

#include "firmware/evaluation_pace.hpp"

namespace firmware {
namespace {

constexpr std::size_t kEvery = 100;
constexpr std::size_t kWindow = 400;

// Windows that are due after each kEvery samples.
struct Loop {
  EvaluationPace pace{kEvery, 100};
  EvaluationPace::Standing standing{
      .settled = true, .oscillating = true, .interruptions = 0, .judged = kWindow};
  double amplitude = 5;
  double period = 25;
  double mean = 50;
  int at = 0;

  bool due() {
    for (std::size_t k = 0; k < kEvery; ++k, ++at) {
      const double phase = 2 * M_PI * at / period;
      pace.push(mean + amplitude * std::sin(phase), 30 - amplitude * std::cos(phase));
    }
    return pace.begins(standing);
  }
  // Windows until the next that is judged.
  int next() {
    for (int k = 1; k < 20; ++k) {
      if (due()) return k;
    }
    return -1;
  }
};

TEST(EvaluationPace, TheFirstWindowIsJudged) {
  EXPECT_EQ(Loop{}.next(), 1);
}

TEST(EvaluationPace, ALoopThatGoesOnIsJudgedOncePerWindow) {
  Loop loop;
  ASSERT_EQ(loop.next(), 1);
  for (int k = 0; k < 5; ++k) EXPECT_EQ(loop.next(), 4);
}

TEST(EvaluationPace, TheShareOfNewSamplesCanBeSet) {
  Loop loop{.pace = {kEvery, 50}};
  ASSERT_EQ(loop.next(), 1);
  EXPECT_EQ(loop.next(), 2);
  Loop always{.pace = {kEvery, 25}};
  ASSERT_EQ(always.next(), 1);
  EXPECT_EQ(always.next(), 1);
}

TEST(EvaluationPace, AShortWindowIsJudgedAgainWhenItHasDoubled) {
  Loop loop;
  loop.standing.judged = 2 * kEvery;
  ASSERT_EQ(loop.next(), 1);
  EXPECT_EQ(loop.next(), 2);
}

TEST(EvaluationPace, AVerdictThatIsNotSettledIsNotWaitedFor) {
  Loop loop;
  loop.standing.settled = false;
  for (int k = 0; k < 5; ++k) EXPECT_EQ(loop.next(), 1);
}

TEST(EvaluationPace, EveryChangeIsJudgedWhenItIsDue) {
  const auto next_after = [](auto change) {
    Loop loop;
    EXPECT_EQ(loop.next(), 1);
    EXPECT_FALSE(loop.due());
    change(loop);
    return loop.next();
  };
  EXPECT_EQ(next_after([](Loop& loop) { loop.amplitude *= 1.3; }), 1);
  EXPECT_EQ(next_after([](Loop& loop) { loop.amplitude = 0; }), 1);
  EXPECT_EQ(next_after([](Loop& loop) { loop.period /= 1.3; }), 1);
  EXPECT_EQ(next_after([](Loop& loop) { loop.mean += 3; }), 1);
  EXPECT_EQ(next_after([](Loop& loop) { loop.standing.oscillating = false; }), 1);
  EXPECT_EQ(next_after([](Loop& loop) { ++loop.standing.interruptions; }), 1);
  EXPECT_EQ(next_after([](Loop&) {}), 3);
}

TEST(EvaluationPace, ALoopAtRestGoesOnToo) {
  Loop loop{.amplitude = 0};
  ASSERT_EQ(loop.next(), 1);
  EXPECT_EQ(loop.next(), 4);
}

TEST(EvaluationPace, ARequestBeginsTheCountAnew) {
  Loop loop;
  ASSERT_EQ(loop.next(), 1);
  ASSERT_FALSE(loop.due());
  ASSERT_FALSE(loop.due());
  loop.pace.forced(loop.standing);
  EXPECT_EQ(loop.next(), 4);
}

}  // namespace
}  // namespace firmware
