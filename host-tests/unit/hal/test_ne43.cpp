#include <gtest/gtest.h>

#include <limits>

#include "hal/ne43.hpp"
#include "support/ident/microseconds.hpp"

namespace hal {
namespace {

using test::kSecond;

TEST(Ne43, SaysWhatTheCurrentSaysAtOnceInsideTheRangeAndAtItsEnds) {
  Ne43 current{{}};
  EXPECT_EQ(current.take(0, 12.0), CurrentState::kGood);
  EXPECT_EQ(current.take(1, 3.8), CurrentState::kSaturated);
  EXPECT_EQ(current.take(2, 20.5), CurrentState::kSaturated);
  EXPECT_EQ(current.take(3, 3.81), CurrentState::kGood);
}

TEST(Ne43, ConfirmsAFailureAfterThreeSecondsAndEndsItAfterThreeMore) {
  Ne43 current{{}};
  EXPECT_EQ(current.take(0, 3.6), CurrentState::kSettling);
  EXPECT_EQ(current.take(3 * kSecond - 1, 0), CurrentState::kSettling);
  EXPECT_EQ(current.take(3 * kSecond, 0), CurrentState::kFailureLow);
  EXPECT_EQ(current.take(10 * kSecond, 12), CurrentState::kFailureLow);
  EXPECT_EQ(current.take(13 * kSecond - 1, 12), CurrentState::kFailureLow);
  EXPECT_EQ(current.take(13 * kSecond, 12), CurrentState::kGood);
}

TEST(Ne43, AShortDropoutIsNoFailure) {
  Ne43 current{{}};
  for (int k = 0; k < 100; ++k) {
    EXPECT_NE(current.take(k * 2 * kSecond, 0), CurrentState::kFailureLow);
    EXPECT_EQ(current.take(k * 2 * kSecond + kSecond, 12), CurrentState::kGood);
  }
}

TEST(Ne43, TheLimitsAreTheCallersAndANanIsABrokenWire) {
  Ne43 current{{.failure_high_ma = 22, .debounce_us = 0}};
  EXPECT_EQ(current.take(0, 21.5), CurrentState::kSaturated);
  EXPECT_EQ(current.take(1, 22), CurrentState::kFailureHigh);
  EXPECT_EQ(current.take(2, std::numeric_limits<double>::quiet_NaN()),
            CurrentState::kFailureLow);
}

}  // namespace
}  // namespace hal
