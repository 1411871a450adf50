#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "ident/signal/sample_window.hpp"
#include "support/ident/microseconds.hpp"

namespace ident {
namespace {

using test::kSecond;

template <class Window>
PushResult push(Window& window, double periods, double value) {
  Sample<double> sample;
  sample.t_us = std::llround(periods * static_cast<double>(window.period_us()));
  sample.u = value;
  sample.y = -value;
  return window.push(sample);
}

template <class Window>
std::vector<double> contents(const Window& window) {
  std::vector<double> u(window.size());
  std::vector<double> y(window.size());
  EXPECT_EQ(window.copy(u, y), u.size());
  for (std::size_t k = 0; k < u.size(); ++k) {
    EXPECT_EQ(y[k], -u[k]);
  }
  return u;
}

using Values = std::vector<double>;

TEST(SampleWindow, KeepsTheNewestOldestFirst) {
  SampleWindow<double, 4> window(kSecond);
  EXPECT_TRUE(window.empty());
  for (int k = 1; k <= 3; ++k) {
    EXPECT_EQ(push(window, k, k), PushResult::kAccepted);
  }
  EXPECT_EQ(contents(window), (Values{1, 2, 3}));
  for (int k = 4; k <= 6; ++k) {
    push(window, k, k);
  }
  EXPECT_EQ(window.size(), 4U);
  EXPECT_EQ(contents(window), (Values{3, 4, 5, 6}));
  EXPECT_EQ(window.newest_us(), 6 * kSecond);
  EXPECT_EQ(window.counters().accepted, 6U);
}

TEST(SampleWindow, CopiesTheNewestThatFit) {
  SampleWindow<double, 8> window(kSecond);
  for (int k = 0; k < 11; ++k) {
    push(window, k, k);
  }
  std::array<double, 3> u{};
  std::array<double, 5> y{};
  EXPECT_EQ(window.copy(u, y), 3U);
  EXPECT_EQ(u, (std::array<double, 3>{8, 9, 10}));
  EXPECT_EQ(y, (std::array<double, 5>{-8, -9, -10, 0, 0}));
  EXPECT_EQ(window.copy(std::span(u).first(0), y), 0U);
}

TEST(SampleWindow, RefusesARepeat) {
  SampleWindow<double, 8> window(kSecond);
  push(window, 0, 1);
  EXPECT_EQ(push(window, 0, 2), PushResult::kRepeat);
  EXPECT_EQ(push(window, 0.49, 3), PushResult::kRepeat);
  EXPECT_EQ(push(window, 0.5, 4), PushResult::kAccepted);
  EXPECT_EQ(contents(window), (Values{1, 4}));
  EXPECT_EQ(window.counters().repeats, 2U);
}

TEST(SampleWindow, RefusesWhatIsNotANumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  SampleWindow<double, 8> window(kSecond);
  push(window, 0, 1);
  EXPECT_EQ(window.push({kSecond, nan, 0}), PushResult::kNonFinite);
  EXPECT_EQ(window.push({kSecond, 0, infinity}), PushResult::kNonFinite);
  EXPECT_EQ(window.push({kSecond, 0, 0, nan, true}), PushResult::kNonFinite);
  EXPECT_EQ(window.push({std::numeric_limits<std::int64_t>::max(), 0, 0}),
            PushResult::kNonFinite);
  EXPECT_EQ(window.push({std::numeric_limits<std::int64_t>::min(), 0, 0}),
            PushResult::kNonFinite);
  EXPECT_EQ(window.counters().non_finite, 5U);
  EXPECT_EQ(window.push({kSecond, 2, -2, nan, false}), PushResult::kAccepted);
  EXPECT_EQ(contents(window), (Values{1, 2}));
}

TEST(SampleWindow, FillsAShortGapByHold) {
  SampleWindow<double, 8> window(kSecond, 3);
  push(window, 0, 1);
  push(window, 1, 2);
  // 4.9 − 1 rounds to 4 slots: three are missing.
  EXPECT_EQ(push(window, 4.9, 5), PushResult::kGap);
  EXPECT_EQ(contents(window), (Values{1, 2, 2, 2, 2, 5}));
  EXPECT_EQ(window.counters().gaps, 1U);
  EXPECT_EQ(window.counters().filled, 3U);
  EXPECT_EQ(window.counters().restarts, 0U);
}

TEST(SampleWindow, HalfASlotTooLateIsInTime) {
  SampleWindow<double, 8> window(kSecond, 3);
  push(window, 0, 1);
  EXPECT_EQ(push(window, 2.5, 3), PushResult::kGap);
  EXPECT_EQ(contents(window), (Values{1, 1, 3}));
}

TEST(SampleWindow, RestartsAfterALongGap) {
  SampleWindow<double, 8> window(kSecond, 3);
  push(window, 0, 1);
  push(window, 1, 2);
  EXPECT_EQ(push(window, 6, 7), PushResult::kGap);
  EXPECT_EQ(contents(window), (Values{7}));
  EXPECT_EQ(window.counters().gaps, 1U);
  EXPECT_EQ(window.counters().filled, 0U);
  EXPECT_EQ(window.counters().restarts, 1U);
  EXPECT_EQ(push(window, 7, 8), PushResult::kAccepted);
}

TEST(SampleWindow, BoundsWhatIsFilled) {
  constexpr int kMost = SampleGrid::kLongestHold;
  for (const int missing : {kMost, kMost + 1}) {
    SampleWindow<double, 32> window(kSecond, 1'000'000);
    push(window, 0, 1);
    push(window, missing + 1, 2);
    EXPECT_EQ(window.size(), missing == kMost ? kMost + 2U : 1U);
  }
}

TEST(SampleWindow, HoldMayBeSwitchedOff) {
  SampleWindow<double, 8> window(kSecond, -1);
  push(window, 0, 1);
  EXPECT_EQ(push(window, 1.5, 2), PushResult::kAccepted);
  EXPECT_EQ(push(window, 3.5, 3), PushResult::kGap);
  EXPECT_EQ(contents(window), (Values{3}));
}

TEST(SampleWindow, RefusesOneSampleFromThePast) {
  SampleWindow<double, 8> window(kSecond);
  push(window, 10, 1);
  EXPECT_EQ(push(window, 5, 9), PushResult::kTimeBack);
  EXPECT_EQ(push(window, 11, 2), PushResult::kAccepted);
  EXPECT_EQ(contents(window), (Values{1, 2}));
  EXPECT_EQ(window.counters().time_back, 1U);
}

TEST(SampleWindow, FollowsAClockThatWasSetBack) {
  SampleWindow<double, 16> window(kSecond);
  push(window, 1000, 1);
  for (int k = 0; k < SampleGrid::kPatience - 1; ++k) {
    EXPECT_EQ(push(window, k, k), PushResult::kTimeBack);
  }
  EXPECT_EQ(push(window, 7, 7), PushResult::kGap);
  EXPECT_EQ(push(window, 8, 8), PushResult::kAccepted);
  EXPECT_EQ(contents(window), (Values{7, 8}));
  EXPECT_EQ(window.counters().time_back, 7U);
  EXPECT_EQ(window.counters().restarts, 1U);
}

TEST(SampleWindow, AStrayStampInTheFutureCostsOneWindowOnly) {
  SampleWindow<double, 16> window(kSecond);
  for (int k = 0; k < 5; ++k) {
    push(window, k, k);
  }
  push(window, 1e9, 0);
  for (int k = 5; k < 20; ++k) {
    push(window, k, k);
  }
  EXPECT_EQ(contents(window), (Values{12, 13, 14, 15, 16, 17, 18, 19}));
}

TEST(SampleWindow, CopiesTheSetpointWhereThereIsOne) {
  SampleWindow<double, 3> window(kSecond);
  window.push({0, 1, -1});
  std::array<double, 3> u{};
  std::array<double, 3> y{};
  std::array<double, 3> sp{};
  window.push({kSecond, 2, -2, 50, true});
  EXPECT_EQ(window.copy(u, y, sp), 2U);
  EXPECT_TRUE(std::isnan(sp[0]));
  EXPECT_EQ(sp[1], 50);
  window.push({2 * kSecond, 3, -3, 51, true});
  window.push({3 * kSecond, 4, -4, 52, true});
  EXPECT_EQ(window.copy(u, y, sp), 3U);
  EXPECT_EQ(sp, (std::array<double, 3>{50, 51, 52}));
}

// The nominal period is wrong by 5 %: after 10 000 samples the plain multiples of it
// would be 500 slots off.
TEST(SampleWindow, FollowsASenderWithAnotherPeriod) {
  for (const double pace : {0.95, 1.05}) {
    SampleWindow<double, 8> window(kSecond);
    for (int k = 0; k < 10000; ++k) {
      EXPECT_EQ(push(window, k * pace, k), PushResult::kAccepted);
    }
  }
}

// The worst jitter: a quarter of a period late until the grid has followed, then early.
TEST(SampleWindow, BearsJitterOfAQuarterPeriod) {
  SampleWindow<double, 8> window(kSecond);
  for (int k = 0; k < 1000; ++k) {
    const double jitter = k / 100 % 2 == 0 ? 0.249 : -0.249;
    EXPECT_EQ(push(window, k + jitter, k), PushResult::kAccepted) << k;
  }
}

TEST(SampleWindow, CountsToTheMicrosecondAfterAHundredYears) {
  SampleWindow<double, 8> window(1000);
  std::int64_t t = std::int64_t{100} * 365 * 24 * 3600 * kSecond;
  for (int k = 0; k < 2000; ++k, t += 1000) {
    ASSERT_EQ(window.push({t, 0, 0}), PushResult::kAccepted);
  }
  EXPECT_EQ(window.newest_us(), t - 1000);
}

TEST(SampleWindow, BoundsThePeriod) {
  EXPECT_EQ((SampleWindow<float, 2>(0).period_us()), 1);
  EXPECT_EQ((SampleWindow<float, 2>(-5).period_us()), 1);
  EXPECT_EQ(
      (SampleWindow<float, 2>(std::numeric_limits<std::int64_t>::max()).period_us()),
      SampleGrid::kLongestPeriod_us);
  SampleWindow<float, 2> longest(SampleGrid::kLongestPeriod_us);
  EXPECT_EQ(longest.push({-SampleGrid::kLargestTime_us, 1, 1}), PushResult::kAccepted);
  EXPECT_EQ(longest.push({SampleGrid::kLargestTime_us, 1, 1}), PushResult::kGap);
}

// One sample, filled: a ring of one holds the newest.
TEST(SampleWindow, OfOneSample) {
  SampleWindow<double, 1> window(kSecond);
  push(window, 0, 1);
  push(window, 3, 2);
  EXPECT_EQ(contents(window), (Values{2}));
  EXPECT_EQ(window.counters().filled, 2U);
}

// What a holder does to u and y, and what others see.
TEST(SampleWindow, HeldSamplesAreInOrderAndNewOnesWait) {
  SampleWindow<double, 64> window(kSecond);
  for (int k = 0; k < 100; ++k) {
    push(window, k, k);
  }
  const auto held = window.hold(60);
  ASSERT_EQ(held.u.size(), 60U);
  EXPECT_TRUE(held.sp.empty());
  for (std::size_t k = 0; k < 60; ++k) {
    EXPECT_EQ(held.u[k], static_cast<double>(40 + k));
    EXPECT_EQ(held.y[k], -static_cast<double>(40 + k));
  }
  const Values before = contents(window);
  EXPECT_EQ(before.size(), 64U);
  for (double& u : held.u) {
    u = (u - 40) / 8;
  }
  for (double& y : held.y) {
    y = (y + 32) / -16;
  }
  window.set_scale({true, 40, 8}, {true, -32, -16});
  EXPECT_EQ(contents(window), before);
  for (int k = 100; k < 104; ++k) {
    push(window, k, k);
  }
  EXPECT_EQ(held.u[0], 0);
  const Values during = contents(window);
  EXPECT_EQ(during.front(), 40);
  EXPECT_EQ(during.back(), 103);
  window.release();
  EXPECT_EQ(contents(window), during);
  EXPECT_EQ(window.counters().overruns, 0U);
  push(window, 104, 104);
  EXPECT_EQ(contents(window).front(), 41);
}

TEST(SampleWindow, SamplesAreTheSameHoweverOftenTheyAreHeld) {
  SampleWindow<float, 64> window(kSecond);
  for (int k = 0; k < 64; ++k) {
    window.push({k * kSecond, 40 + 0.3F * static_cast<float>(k % 7),
                 1000 - 0.01F * static_cast<float>(k % 11), 0, false});
  }
  std::array<float, 64> u, y, first_u, first_y;
  for (int round = 0; round < 20; ++round) {
    const auto held = window.hold(64);
    const auto of_u = scale_of_range<float>(held.u);
    const auto of_y = scale_of_variance<float>(held.y);
    of_u.apply(held.u);
    of_y.apply(held.y);
    window.set_scale(of_u, of_y);
    window.release();
    window.copy(u, y);
    if (round == 0) {
      first_u = u;
      first_y = y;
    }
    ASSERT_EQ(u, first_u) << round;
    ASSERT_EQ(y, first_y) << round;
  }
}

TEST(SampleWindow, HoldsTheSetpointsOfAWindowThatHasThemAll) {
  SampleWindow<double, 64> window(kSecond);
  for (int k = 0; k < 10; ++k) {
    window.push({k * kSecond, 1.0 * k, 0, 5.0 + k, k > 3});
  }
  EXPECT_TRUE(window.hold(10).sp.empty());
  window.release();
  const auto held = window.hold(5);
  ASSERT_EQ(held.sp.size(), 5U);
  EXPECT_EQ(held.sp[0], 10);
  window.release();
  EXPECT_EQ(window.size(), 10U);
}

TEST(SampleWindow, TooManyThatWaitStartItAnew) {
  using Window = SampleWindow<double, 256>;
  Window window(kSecond);
  for (int k = 0; k < 256; ++k) {
    push(window, k, k);
  }
  const auto held = window.hold(256);
  const int waiting = static_cast<int>(Window::kWaiting);
  for (int k = 256; k < 256 + waiting; ++k) {
    push(window, k, k);
  }
  EXPECT_EQ(window.size(), 256U);
  EXPECT_EQ(window.counters().overruns, 0U);
  push(window, 256 + waiting, 1);
  EXPECT_EQ(window.counters().overruns, 1U);
  EXPECT_EQ(contents(window), Values{1});
  EXPECT_EQ(held.u[0], 0);  // the holder's all the same
  push(window, 257 + waiting, 2);
  window.release();
  EXPECT_EQ(contents(window), (Values{1, 2}));
}

TEST(SampleWindow, ALongGapWhileHeldStartsItAnew) {
  SampleWindow<double, 256> window(kSecond);
  for (int k = 0; k < 100; ++k) {
    push(window, k, k);
  }
  (void)window.hold(100);
  push(window, 100, 100);
  push(window, 200, 7);
  EXPECT_EQ(contents(window), Values{7});
  window.release();
  EXPECT_EQ(contents(window), Values{7});
  EXPECT_EQ(window.counters().restarts, 1U);
  // A short gap is filled with the last value, wherever that is.
  (void)window.hold(1);
  push(window, 203, 9);
  EXPECT_EQ(contents(window), (Values{7, 7, 7, 9}));
  window.release();
  EXPECT_EQ(contents(window), (Values{7, 7, 7, 9}));
}

TEST(SampleWindow, TimeGoesBackFromTheNewestSampleAlsoAfterAGap) {
  SampleWindow<double, 16> window(kSecond);
  push(window, 0, 0);
  push(window, 1, 1);
  EXPECT_EQ(push(window, 3.3, 2), PushResult::kGap);
  EXPECT_EQ(push(window, 3.2, 3), PushResult::kTimeBack);
  EXPECT_EQ(push(window, 3.3, 3), PushResult::kRepeat);
  EXPECT_EQ(push(window, 4.3, 3), PushResult::kAccepted);
  EXPECT_EQ(window.counters().time_back, 1U);
  EXPECT_EQ(contents(window), (Values{0, 1, 1, 2, 3}));
}

}  // namespace
}  // namespace ident
