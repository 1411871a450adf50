#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "ident/verdict/alarm.hpp"

namespace ident {
namespace {

constexpr float kLarge = 5;  // band, % of span

AlarmChange stiction(Alarm& alarm, float band_pct = kLarge) {
  return alarm.take(Verdict::kStiction, band_pct, true);
}
AlarmChange healthy(Alarm& alarm) {
  return alarm.take(Verdict::kNoStiction, 0, true);
}
AlarmChange undecided(Alarm& alarm, bool oscillates) {
  return alarm.take(Verdict::kUndecided, 0, oscillates);
}

Alarm raised(AlarmSettings settings = {}) {
  Alarm alarm(settings);
  for (int k = 0; k < settings.on_delay_windows; ++k) {
    stiction(alarm);
  }
  EXPECT_TRUE(alarm.raised());
  return alarm;
}

TEST(Alarm, GoesOnAfterARestartWhereItWas) {
  Alarm before = raised();
  for (int k = 0; k < 4; ++k) healthy(before);
  Alarm after{AlarmSettings{}};
  after.restore(before.state());
  EXPECT_TRUE(after.raised());
  EXPECT_EQ(healthy(after), AlarmChange::kNone);
  EXPECT_EQ(healthy(after), AlarmChange::kCleared) << "six windows against it in all";
  after.restore({false, 1});
  EXPECT_EQ(stiction(after), AlarmChange::kRaised) << "two windows for it in all";
}

TEST(Alarm, RaisesAfterTheOnDelayAndTellsOnce) {
  Alarm alarm{AlarmSettings{}};
  EXPECT_FALSE(alarm.raised());
  EXPECT_EQ(stiction(alarm), AlarmChange::kNone);
  EXPECT_EQ(stiction(alarm), AlarmChange::kRaised);
  EXPECT_TRUE(alarm.raised());
  EXPECT_EQ(stiction(alarm), AlarmChange::kNone);
}

TEST(Alarm, AnyOtherVerdictBreaksTheOnDelay) {
  for (const Verdict verdict : {Verdict::kNoStiction, Verdict::kBacklash,
                                Verdict::kUndecided, Verdict::kBadData}) {
    Alarm alarm{AlarmSettings{}};
    for (int k = 0; k < 5; ++k) {
      EXPECT_EQ(stiction(alarm), AlarmChange::kNone);
      EXPECT_EQ(alarm.take(verdict, kLarge, true), AlarmChange::kNone);
    }
  }
}

TEST(Alarm, ClearsAfterTheOffDelayAndTellsOnce) {
  Alarm alarm = raised();
  for (int k = 0; k < 5; ++k) {
    EXPECT_EQ(healthy(alarm), AlarmChange::kNone);
  }
  EXPECT_EQ(healthy(alarm), AlarmChange::kCleared);
  EXPECT_FALSE(alarm.raised());
  EXPECT_EQ(healthy(alarm), AlarmChange::kNone);
}

TEST(Alarm, StictionStartsTheOffDelayAnew) {
  Alarm alarm = raised();
  for (int round = 0; round < 5; ++round) {
    for (int k = 0; k < 5; ++k) {
      EXPECT_EQ(healthy(alarm), AlarmChange::kNone);
    }
    EXPECT_EQ(stiction(alarm), AlarmChange::kNone);
  }
  EXPECT_TRUE(alarm.raised());
}

TEST(Alarm, UndecidedSaysNothingWhileTheLoopOscillates) {
  Alarm alarm = raised();
  for (int k = 0; k < 100; ++k) {
    EXPECT_EQ(undecided(alarm, true), AlarmChange::kNone);
    EXPECT_EQ(alarm.take(Verdict::kBadData, 0, false), AlarmChange::kNone);
  }
  for (int k = 0; k < 5; ++k) {
    EXPECT_EQ(healthy(alarm), AlarmChange::kNone);
    EXPECT_EQ(undecided(alarm, true), AlarmChange::kNone);
  }
  EXPECT_EQ(healthy(alarm), AlarmChange::kCleared);
}

TEST(Alarm, ClearsWhenNothingIsLeftToComplainAbout) {
  Alarm alarm = raised();
  for (int k = 0; k < 5; ++k) {
    EXPECT_EQ(undecided(alarm, false), AlarmChange::kNone);
  }
  EXPECT_EQ(undecided(alarm, false), AlarmChange::kCleared);
}

TEST(Alarm, SmallBandsDoNotRaise) {
  Alarm alarm{AlarmSettings{}};
  for (int k = 0; k < 10; ++k) {
    EXPECT_EQ(stiction(alarm, 0.49f), AlarmChange::kNone);
  }
  EXPECT_EQ(stiction(alarm, 0.5f), AlarmChange::kNone);
  EXPECT_EQ(stiction(alarm, 0.5f), AlarmChange::kRaised);
}

TEST(Alarm, HysteresisKeepsABandAtTheLimitFromChattering) {
  AlarmSettings settings;
  settings.on_delay_windows = settings.off_delay_windows = 1;
  Alarm alarm = raised(settings);
  for (int k = 0; k < 20; ++k) {
    EXPECT_EQ(stiction(alarm, k % 2 == 0 ? 0.41f : 0.51f), AlarmChange::kNone);
  }
  EXPECT_EQ(stiction(alarm, 0.39f), AlarmChange::kCleared);
  EXPECT_EQ(stiction(alarm, 0.49f), AlarmChange::kNone);
}

TEST(Alarm, SettingsOutsideTheirRangesAreMovedToTheBound) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Alarm eager(AlarmSettings{-3, 0, nan, 1e9f});
  EXPECT_EQ(stiction(eager, 0), AlarmChange::kRaised);
  EXPECT_EQ(healthy(eager), AlarmChange::kCleared);
  Alarm slow(AlarmSettings{1 << 30, 1 << 30, 0, 0});
  for (int k = 0; k < 999; ++k) {
    ASSERT_EQ(stiction(slow), AlarmChange::kNone);
  }
  EXPECT_EQ(stiction(slow), AlarmChange::kRaised);
}

TEST(Alarm, NeverChangesFasterThanItsDelays) {
  std::mt19937 random(5);
  AlarmSettings settings;
  settings.on_delay_windows = 2;
  settings.off_delay_windows = 3;
  Alarm alarm(settings);
  int since = 0;
  int changes = 0;
  for (int k = 0; k < 20000; ++k) {
    ++since;
    const Verdict verdict = static_cast<Verdict>(random() % 5);
    const float band = static_cast<float>(random() % 100) / 100.0f;
    const AlarmChange change = alarm.take(verdict, band, random() % 2 == 0);
    if (change != AlarmChange::kNone) {
      EXPECT_GE(since, change == AlarmChange::kRaised ? 2 : 3);
      EXPECT_EQ(alarm.raised(), change == AlarmChange::kRaised);
      since = 0;
      ++changes;
    }
  }
  EXPECT_GT(changes, 100);
}

}  // namespace
}  // namespace ident
