#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "firmware/loop_input.hpp"
#include "support/ident/microseconds.hpp"

namespace firmware {
namespace {

using wire::InputStatus;

using test::kSecond;

config::Source can_source(std::uint32_t id) {
  config::Source source;
  source.signal.frame_id = id;
  source.signal.signal.length = 16;
  return source;
}

wire::CanFrame frame_of(std::uint32_t id, int value) {
  wire::CanFrame frame{.id = id, .dlc = 8, .data = {}};
  frame.data[0] = static_cast<std::uint8_t>(value);
  frame.data[1] = static_cast<std::uint8_t>(value >> 8);
  return frame;
}

class Input : public testing::Test {
 protected:
  Input() {
    loop.u = can_source(1);
    loop.y = can_source(2);
  }
  // One second of both signals; the samples that came out of it.
  int tick(LoopInput& input, int u = 50, int y = 50) {
    now += kSecond;
    ident::Sample<float> sample;
    int count = 0;
    while (input.next(now - 1, sample)) ++count;
    if (u >= 0) input.take_frame(Role::kU, now, frame_of(1, u));
    if (y >= 0) input.take_frame(Role::kY, now, frame_of(2, y));
    return count;
  }
  int run(LoopInput& input, int seconds, int u = 50, int y = 50) {
    int count = 0;
    for (int k = 0; k < seconds; ++k) count += tick(input, u, y);
    return count;
  }

  config::Loop loop;
  std::int64_t now = 100 * kSecond;
};

TEST_F(Input, ValuesThatNothingExplainsAreRefusedCountedAndTold) {
  for (config::Source* source : {&loop.u, &loop.y}) {
    source->signal.signal.type = wire::ValueType::kFloat32;
    source->signal.signal.length = 32;
  }
  const auto frame = [](std::uint32_t id, float value) {
    wire::CanFrame out{.id = id, .dlc = 4, .data = {}};
    std::memcpy(out.data.data(), &value, sizeof value);
    return out;
  };
  LoopInput input(loop);
  float largest = 0;
  int samples = 0;
  for (int k = 0; k < 100; ++k, now += kSecond) {
    ident::Sample<float> sample;
    while (input.next(now - 1, sample)) {
      largest = std::max({largest, std::abs(sample.u), std::abs(sample.y)});
      ++samples;
    }
    const float wild = k % 20 < 10 ? 3e38F : std::numeric_limits<float>::quiet_NaN();
    input.take_frame(Role::kU, now, frame(1, 50));
    input.take_frame(Role::kY, now, frame(2, k % 10 == 5 ? wild : 20));
    if (k == 6) {
      EXPECT_EQ(input.status(now), InputStatus::kUncertain);
    }
  }
  EXPECT_EQ(largest, 50);
  EXPECT_GE(samples, 80);
  EXPECT_EQ(input.counters().refused_values, 10U);
  EXPECT_EQ(input.status(now), InputStatus::kUncertain);
}

TEST_F(Input, GivesASampleForEachPeriodWhileValuesCome) {
  LoopInput input(loop);
  EXPECT_EQ(input.status(now), InputStatus::kUncertain);
  EXPECT_GE(run(input, 20), 12);
  EXPECT_EQ(input.status(now), InputStatus::kGood);
  EXPECT_EQ(input.live(Role::kU), 50);
  EXPECT_TRUE(std::isnan(input.live(Role::kSp)));
  EXPECT_EQ(input.counters().frames, 40U);
}

TEST_F(Input, ASilentSignalIsMissingAfterItsTimeAndNoSamplesComeFromIt) {
  LoopInput input(loop);
  run(input, 20);
  run(input, 5, 50, -1);
  EXPECT_EQ(input.status(now), InputStatus::kGood);
  run(input, 2, 50, -1);
  EXPECT_EQ(input.status(now), InputStatus::kMissing);
  EXPECT_EQ(run(input, 10, 50, -1), 0);
  run(input, 3);
  EXPECT_EQ(input.status(now), InputStatus::kGood);
  EXPECT_EQ(run(input, 10), 10);
  EXPECT_EQ(input.counters().stale, 1U);
  EXPECT_GT(input.counters().gaps, 0U);
}

TEST_F(Input, AValueOutsideItsRangeIsNotUsed) {
  loop.y.has_range = true;
  loop.y.maximum = 100;
  LoopInput input(loop);
  run(input, 20);
  run(input, 4, 50, 101);
  EXPECT_EQ(input.live(Role::kY), 50);
  run(input, 4, 50, 101);
  EXPECT_EQ(input.status(now), InputStatus::kOutOfRange);
  run(input, 8, 50, 0xFFFF);
  EXPECT_EQ(input.status(now), InputStatus::kMissing) << "all bits set: not available";
}

TEST_F(Input, TheHighestRawNumberBeyondTheSpanIsNotAvailable) {
  LoopInput input(loop);
  run(input, 20);
  run(input, 4, 0xFFFF);
  EXPECT_EQ(input.live(Role::kU), 50);
  EXPECT_EQ(input.counters().refused_values, 0U);
  run(input, 4, 50, 0xFFFF);
  EXPECT_EQ(input.live(Role::kY), 0xFFFF) << "nobody gave a span of y";
}

TEST_F(Input, OfTwoSendersTheFirstIsUsedAndANewAddressIsFollowed) {
  loop.u.signal.ignored = 0xFF;
  loop.u.signal.frame_id = 0x100;
  LoopInput input(loop);
  const auto both = [&](int seconds, bool first) {
    for (int k = 0; k < seconds; ++k) {
      tick(input, -1);
      if (first) input.take_frame(Role::kU, now, frame_of(0x121, 50));
      input.take_frame(Role::kU, now, frame_of(0x122, 70));
    }
  };
  both(20, true);
  EXPECT_EQ(input.live(Role::kU), 50);
  EXPECT_EQ(input.status(now), InputStatus::kUncertain);
  ASSERT_TRUE(input.two_senders());
  EXPECT_EQ(input.two_senders()->role, Role::kU);
  EXPECT_EQ(input.two_senders()->used, 0x21);
  EXPECT_EQ(input.two_senders()->other, 0x22);
  both(12, false);
  EXPECT_EQ(input.live(Role::kU), 50) << "another device, silent or not";
  EXPECT_EQ(input.status(now), InputStatus::kMissing);

  LoopInput renamed(loop);
  for (int k = 0; k < 40; ++k) {
    tick(renamed, -1);
    renamed.take_frame(Role::kU, now, frame_of(k < 20 ? 0x121 : 0x122, k < 20 ? 50 : 70));
  }
  EXPECT_EQ(renamed.live(Role::kU), 70);
  EXPECT_FALSE(renamed.two_senders());
}

TEST_F(Input, AValueThatStaysFarOutsideTheSpanIsOutOfRange) {
  LoopInput input(loop);
  run(input, 20);
  run(input, 4, 4600, 4600);
  EXPECT_EQ(input.status(now), InputStatus::kGood) << "not for long";
  run(input, 4, 4600, 4600);
  EXPECT_EQ(input.status(now), InputStatus::kOutOfRange);
  ASSERT_TRUE(input.far_signal());
  EXPECT_EQ(input.far_signal()->role, Role::kU);
  EXPECT_EQ(input.far_signal()->value, 4600);
  EXPECT_EQ(run(input, 10, 4600, 4600), 0) << "no samples";
  run(input, 8, 50, 4600);
  EXPECT_EQ(input.status(now), InputStatus::kGood) << "nobody gave a span of y";
  loop.has_y_span = true;
  LoopInput spanned(loop);
  run(spanned, 8, 50, 4600);
  EXPECT_EQ(spanned.status(now), InputStatus::kOutOfRange);
  EXPECT_EQ(spanned.far_signal()->role, Role::kY);
}

TEST_F(Input, SignalsThatComeMoreSeldomThanSamplesAreTakenAreKnown) {
  LoopInput input(loop);
  run(input, 40);
  EXPECT_FALSE(input.slow_signal()) << "once a period";
  loop.sample_period_s = 0.2;
  LoopInput fast(loop);
  run(fast, 10);
  EXPECT_FALSE(fast.slow_signal()) << "not known yet";
  run(fast, 30);
  ASSERT_TRUE(fast.slow_signal());
  EXPECT_DOUBLE_EQ(fast.slow_signal()->interval_s, 1);
}

TEST_F(Input, ManualModeSuspendsWithoutAFault) {
  loop.mode = can_source(3);
  loop.auto_values = {1, 4};
  LoopInput input(loop);
  run(input, 10);
  EXPECT_EQ(input.mode(), wire::LoopMode::kUnknown);
  input.take_frame(Role::kMode, now, frame_of(3, 0));
  EXPECT_EQ(input.mode(), wire::LoopMode::kManual);
  EXPECT_EQ(run(input, 10), 0);
  EXPECT_EQ(input.status(now), InputStatus::kGood);
  input.take_frame(Role::kMode, now, frame_of(3, 4));
  EXPECT_EQ(run(input, 10), 10);
}

TEST_F(Input, AnAliveCounterThatStandsStillMeansMissing) {
  loop.alive = can_source(4);
  LoopInput input(loop);
  for (int k = 0; k < 20; ++k) {
    tick(input);
    input.take_frame(Role::kAlive, now, frame_of(4, k % 4));
  }
  EXPECT_EQ(input.status(now), InputStatus::kGood);
  for (int k = 0; k < 7; ++k) {
    tick(input);
    input.take_frame(Role::kAlive, now, frame_of(4, 3));
  }
  EXPECT_EQ(input.status(now), InputStatus::kMissing);
  EXPECT_EQ(run(input, 3), 0);
}

TEST_F(Input, ACurrentLoopIsScaledAndItsFailureConfirmedAfterThreeSeconds) {
  loop.u.kind = config::SourceKind::kIio;
  loop.u.shunt_ohm = 250;
  loop.u.is_current = true;
  loop.u.ne43 = true;
  LoopInput input(loop);
  const auto second = [&](double milliamperes) {
    tick(input, -1);
    input.take_reading(Role::kU, now, true, milliamperes * 250);
  };
  for (int k = 0; k < 20; ++k) second(12);
  EXPECT_NEAR(input.live(Role::kU), 50, 1e-9);
  EXPECT_EQ(input.status(now), InputStatus::kGood);
  second(20.6);
  EXPECT_EQ(input.status(now), InputStatus::kUncertain) << "saturated, but used";
  for (int k = 0; k < 3; ++k) second(2);
  EXPECT_NEAR(input.live(Role::kU), 103.75, 1e-9) << "a failure is never a value";
  EXPECT_NE(input.status(now), InputStatus::kCurrentLow);
  second(2);
  EXPECT_EQ(input.status(now), InputStatus::kCurrentLow);
  EXPECT_EQ(input.counters().ne43_faults, 1U);
  for (int k = 0; k < 4; ++k) second(22);
  EXPECT_EQ(input.status(now), InputStatus::kCurrentHigh);
  for (int k = 0; k < 4; ++k) second(12);
  EXPECT_TRUE(wire::is_usable(input.status(now)));
}

TEST_F(Input, ARegisterIsScaledAndHeldAgainstItsRange) {
  loop.u.kind = config::SourceKind::kModbus;
  loop.u.scale = 0.01;
  loop.u.offset = -5;
  loop.u.has_range = true;
  loop.u.minimum = -5;
  loop.u.maximum = 105;
  LoopInput input(loop);
  tick(input, -1);
  input.take_reading(Role::kU, now, true, 5500);
  EXPECT_NEAR(input.live(Role::kU), 50, 1e-9);
  input.take_reading(Role::kU, now, true, 12'000);
  EXPECT_NEAR(input.live(Role::kU), 50, 1e-9) << "out of range: not used";
  EXPECT_EQ(input.counters().refused_values, 1U);
}

TEST_F(Input, ADeviceThatDoesNotAnswerIsMissing) {
  loop.u.kind = config::SourceKind::kHwmon;
  loop.u.is_current = true;
  LoopInput input(loop);
  for (int k = 0; k < 8; ++k) {
    tick(input, -1);
    input.take_reading(Role::kU, now, false, 0);
  }
  EXPECT_EQ(input.status(now), InputStatus::kMissing);
}

TEST_F(Input, LostFramesAreCountedAndMakeItUncertain) {
  LoopInput input(loop);
  run(input, 20);
  input.take_drops(now, 5);
  EXPECT_EQ(input.counters().dropped, 5U);
  EXPECT_EQ(input.status(now), InputStatus::kUncertain);
  run(input, 70);
  EXPECT_EQ(input.status(now), InputStatus::kGood);
}

}  // namespace
}  // namespace firmware
