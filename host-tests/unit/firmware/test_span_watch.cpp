#include <gtest/gtest.h>

#include <cmath>

#include "firmware/span_watch.hpp"

namespace firmware {
namespace {

constexpr int kWatchWindow = 200;

// Whether a loop that oscillates, or not, between `low` and `high` doubts its span.
bool doubts(std::array<double, 2> span, double low, double high, bool oscillates = true) {
  SpanWatch watch(span, kWatchWindow);
  bool complete = false;
  for (int k = 0; k < kWatchWindow; ++k) {
    EXPECT_FALSE(complete) << k;
    complete = watch.push(low + (high - low) * (0.5 + 0.5 * std::sin(0.3 * k)));
  }
  EXPECT_TRUE(complete);
  EXPECT_NEAR(watch.range()[0], low, 0.01 * (high - low));
  EXPECT_NEAR(watch.range()[1], high, 0.01 * (high - low));
  return watch.doubted(oscillates);
}

TEST(SpanWatch, BelievesASpanThatUUses) {
  EXPECT_FALSE(doubts({0, 100}, 0, 100));
  EXPECT_FALSE(doubts({0, 100}, 45, 48));
  EXPECT_FALSE(doubts({0, 100}, -5, 60)) << "a little beyond an end";
}

TEST(SpanWatch, DoubtsASpanInAnotherUnit) {
  EXPECT_TRUE(doubts({0, 1}, 0, 100));
  EXPECT_TRUE(doubts({0, 1}, 40, 60, false));
  EXPECT_TRUE(doubts({0, 100}, 0.2, 0.8));
  EXPECT_TRUE(doubts({0, 100}, 4000, 4100));
}

TEST(SpanWatch, ALoopAtRestNeedsNoSpan) {
  EXPECT_FALSE(doubts({0, 100}, 50, 50.1, false));
}

TEST(SpanWatch, EachWindowSpeaksForItself) {
  SpanWatch watch({0, 1}, 2);
  for (int round = 0; round < 2; ++round) {
    EXPECT_FALSE(watch.push(50));
    EXPECT_TRUE(watch.push(50));
    EXPECT_TRUE(watch.doubted(false));
    EXPECT_FALSE(watch.push(0.2));
    EXPECT_TRUE(watch.push(0.7));
    EXPECT_FALSE(watch.doubted(true));
    EXPECT_EQ(watch.range(), (std::array<double, 2>{0.2, 0.7}));
  }
}

}  // namespace
}  // namespace firmware
