#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

#include "ident/signal/input_health.hpp"
#include "support/ident/microseconds.hpp"

namespace ident {
namespace {

using test::kSecond;

// A loop sampled once a second, its window and its health.
class Feed {
 public:
  explicit Feed(const InputHealthSettings& settings = {}) : health_(settings, kSecond) {}

  HealthChange push(double u, double y) {
    now_ += kSecond;
    const Sample<double> sample{now_, u, y};
    return health_.push(sample, window_.push(sample), period);
  }
  /// Pushes until something changes, `most` samples at most; how many it took.
  template <class Signal>
  int until_change(int most, HealthChange expected, Signal signal) {
    for (int k = 1; k <= most; ++k) {
      const auto [u, y] = signal(++count_);
      const HealthChange change = push(u, y);
      if (change != HealthChange::kNone) {
        EXPECT_EQ(change, expected);
        return k;
      }
    }
    return 0;
  }
  /// As `until_change`, at the time of the newest sample.
  int stand_until_change(int most) {
    for (int k = 1; k <= most; ++k) {
      wait(-1);
      if (push(k, k) != HealthChange::kNone) {
        return k;
      }
    }
    return 0;
  }
  void wait(double seconds) { now_ += static_cast<std::int64_t>(seconds * 1e6); }
  HealthChange advance(double seconds) {
    return health_.advance(now_ + static_cast<std::int64_t>(seconds * 1e6));
  }
  [[nodiscard]] InputFault fault() const { return health_.fault(); }
  [[nodiscard]] double changed_s() const {
    return static_cast<double>(health_.changed_us()) * 1e-6;
  }
  [[nodiscard]] double now_s() const { return static_cast<double>(now_) * 1e-6; }

  double period = 0;

 private:
  SampleWindow<double, 8> window_{kSecond};
  InputHealth<double> health_;
  std::int64_t now_ = 0;
  int count_ = 0;
};

struct Readings {
  double u;
  double y;
};
Readings alive(int k) {
  return {50.0 + k % 7, 20.0 + k % 5};
}
Readings y_frozen(int k) {
  return {50.0 + k % 7, 20.0};
}
Readings u_frozen(int k) {
  return {50.0, 20.0 + k % 5};
}

TEST(InputHealth, GoodSamplesAreNoFault) {
  Feed feed;
  EXPECT_EQ(feed.until_change(5000, HealthChange::kNone, alive), 0);
  EXPECT_EQ(feed.fault(), InputFault::kNone);
}

TEST(InputHealth, AGapIsStaleFromTheMomentTheSampleWasOverdue) {
  Feed feed;
  feed.until_change(10, HealthChange::kNone, alive);
  feed.wait(3);
  EXPECT_EQ(feed.until_change(1, HealthChange::kNone, alive), 0);
  const double last = feed.now_s();
  feed.wait(20);
  EXPECT_EQ(feed.until_change(1, HealthChange::kFault, alive), 1);
  EXPECT_EQ(feed.fault(), InputFault::kStale);
  EXPECT_EQ(feed.changed_s(), last + 5);
  EXPECT_EQ(feed.until_change(100, HealthChange::kRestored, alive), 5);
  EXPECT_EQ(feed.fault(), InputFault::kNone);
  EXPECT_EQ(feed.changed_s(), feed.now_s());
}

TEST(InputHealth, AClockFindsTheSameFaultWithoutASample) {
  Feed feed;
  EXPECT_EQ(feed.advance(1000), HealthChange::kNone);
  feed.until_change(10, HealthChange::kNone, alive);
  EXPECT_EQ(feed.advance(5), HealthChange::kNone);
  EXPECT_EQ(feed.advance(5.1), HealthChange::kFault);
  EXPECT_EQ(feed.changed_s(), feed.now_s() + 5);
  EXPECT_EQ(feed.advance(100), HealthChange::kNone);
  EXPECT_EQ(feed.fault(), InputFault::kStale);
  feed.wait(200);
  EXPECT_EQ(feed.until_change(100, HealthChange::kRestored, alive), 6);
}

TEST(InputHealth, SlowSamplesStayOneFault) {
  Feed feed;
  int changes = 0;
  for (int k = 0; k < 50; ++k) {
    feed.wait(8);
    changes += feed.push(k, k) != HealthChange::kNone ? 1 : 0;
  }
  EXPECT_EQ(changes, 1);
  EXPECT_EQ(feed.fault(), InputFault::kStale);
}

TEST(InputHealth, AClockThatStandsStillIsStale) {
  Feed feed;
  feed.until_change(10, HealthChange::kNone, alive);
  EXPECT_EQ(feed.stand_until_change(1000), InputHealth<double>::kStanding);
  EXPECT_EQ(feed.fault(), InputFault::kStale);
  EXPECT_EQ(feed.changed_s(), feed.now_s());
  EXPECT_EQ(feed.stand_until_change(1000), 0) << "one fault";
  EXPECT_EQ(feed.until_change(100, HealthChange::kRestored, alive), 5);
}

TEST(InputHealth, RepeatsWhoseClockRunsAreNoFault) {
  Feed feed;
  for (int k = 0; k < 5000; ++k) {
    feed.wait(-0.99);
    EXPECT_EQ(feed.push(k, k), HealthChange::kNone);
  }
}

TEST(InputHealth, ASingleNonFiniteSampleIsNoFaultARunOfThemIs) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Feed feed;
  feed.until_change(10, HealthChange::kNone, alive);
  EXPECT_EQ(feed.push(nan, 0), HealthChange::kNone);
  feed.until_change(10, HealthChange::kNone, alive);
  const double last = feed.now_s();
  EXPECT_EQ(feed.until_change(100, HealthChange::kFault,
                              [&](int) {
                                return Readings{0, nan};
                              }),
            6);
  EXPECT_EQ(feed.fault(), InputFault::kNonFinite);
  EXPECT_EQ(feed.changed_s(), last + 5);
  EXPECT_GT(feed.until_change(100, HealthChange::kRestored, alive), 0);
}

TEST(InputHealth, IsRestoredByUsableSamplesInARow) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto no_number = [nan](int) { return Readings{0, nan}; };
  Feed at_once;
  Feed interrupted;
  for (Feed* feed : {&at_once, &interrupted}) {
    feed->until_change(10, HealthChange::kNone, alive);
    feed->until_change(100, HealthChange::kFault, no_number);
  }
  const int needed = at_once.until_change(100, HealthChange::kRestored, alive);
  ASSERT_GT(needed, 1);
  EXPECT_EQ(interrupted.until_change(needed - 1, HealthChange::kNone, alive), 0);
  EXPECT_EQ(interrupted.push(0, nan), HealthChange::kNone);
  EXPECT_GE(interrupted.until_change(100, HealthChange::kRestored, alive), needed - 1);
}

TEST(InputHealth, FindsASenderThatNeverSendsANumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Feed feed;
  EXPECT_EQ(feed.until_change(100, HealthChange::kFault,
                              [&](int) {
                                return Readings{nan, 0};
                              }),
            7);
  EXPECT_EQ(feed.fault(), InputFault::kNonFinite);
}

TEST(InputHealth, AFrozenSignalIsAFaultWhileTheOtherMoves) {
  for (const bool of_y : {false, true}) {
    Feed feed;
    feed.until_change(10, HealthChange::kNone, alive);
    EXPECT_NEAR(feed.until_change(1000, HealthChange::kFault, of_y ? y_frozen : u_frozen),
                512, 1);
    EXPECT_EQ(feed.fault(), of_y ? InputFault::kFrozenY : InputFault::kFrozenU);
    EXPECT_EQ(feed.until_change(1000, HealthChange::kNone, of_y ? y_frozen : u_frozen),
              0);
    EXPECT_EQ(feed.until_change(100, HealthChange::kRestored, alive), 5);
  }
}

TEST(InputHealth, APlantAtRestIsNoFault) {
  Feed feed;
  EXPECT_EQ(feed.until_change(5000, HealthChange::kNone,
                              [](int) {
                                return Readings{50, 20};
                              }),
            0);
  // Nor does it become one at the first move of u.
  EXPECT_EQ(feed.until_change(10, HealthChange::kNone, y_frozen), 0);
}

TEST(InputHealth, AStuckValveOfASlowLoopIsNoFault) {
  Feed feed;
  feed.period = 1600;
  const auto stuck_for_half_a_period = [](int k) {
    return Readings{50.0 + k % 800, k / 800 % 2 == 0 ? 20.0 : 30.0};
  };
  EXPECT_EQ(feed.until_change(10000, HealthChange::kNone, stuck_for_half_a_period), 0);
  feed.period = 100;
  EXPECT_GT(feed.until_change(10000, HealthChange::kFault, stuck_for_half_a_period), 0);
}

TEST(InputHealth, FrozenCanBeSwitchedOff) {
  InputHealthSettings settings;
  settings.frozen_after_samples = 0;
  Feed feed(settings);
  EXPECT_EQ(feed.until_change(10000, HealthChange::kNone, y_frozen), 0);
}

TEST(InputHealth, SettingsOutsideTheirRangesAreMovedToTheBound) {
  InputHealthSettings settings;
  settings.stale_after_us = 1;         // 2 periods
  settings.frozen_after_samples = -5;  // 8 samples
  settings.restore_after_samples = 0;  // 1 sample
  Feed feed(settings);
  feed.until_change(3, HealthChange::kNone, alive);
  feed.wait(1);
  EXPECT_EQ(feed.until_change(1, HealthChange::kNone, alive), 0);
  feed.wait(2);
  EXPECT_EQ(feed.until_change(1, HealthChange::kFault, alive), 1);
  EXPECT_EQ(feed.until_change(1, HealthChange::kRestored, alive), 1);
  EXPECT_NEAR(feed.until_change(100, HealthChange::kFault, y_frozen), 8, 1);
}

TEST(InputHealth, AClockSetBackIsNotStale) {
  Feed feed;
  feed.wait(1e6);
  feed.until_change(10, HealthChange::kNone, alive);
  feed.wait(-5e5);
  EXPECT_EQ(feed.until_change(100, HealthChange::kNone, alive), 0);
}

TEST(InputHealth, EveryFaultHasItsName) {
  EXPECT_EQ(name(InputFault::kNone), "none");
  EXPECT_EQ(name(InputFault::kStale), "stale");
  EXPECT_EQ(name(InputFault::kNonFinite), "non_finite");
  EXPECT_EQ(name(InputFault::kFrozenU), "frozen_u");
  EXPECT_EQ(name(InputFault::kFrozenY), "frozen_y");
}

}  // namespace
}  // namespace ident
