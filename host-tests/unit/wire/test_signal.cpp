#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "wire/signal.hpp"

namespace wire {
namespace {

Signal layout(unsigned start, unsigned length, ByteOrder order, bool is_signed = false) {
  Signal s;
  s.start = static_cast<std::uint16_t>(start);
  s.length = static_cast<std::uint16_t>(length);
  s.byte_order = order;
  s.is_signed = is_signed;
  return s;
}

CanFrame frame_of(std::array<std::uint8_t, 8> data) {
  CanFrame frame;
  frame.dlc = 8;
  std::copy(data.begin(), data.end(), frame.data.begin());
  return frame;
}

constexpr ByteOrder kIntel = ByteOrder::kLittleEndian;
constexpr ByteOrder kMotorola = ByteOrder::kBigEndian;

// Message of the cantools documentation: Enable 7|1@0+, AverageRadius 6|6@0+ (0.1,0),
// Temperature 0|12@0- (0.01,250).
TEST(Signal, MotorolaStartIsTheMostSignificantBit) {
  Signal temperature = layout(0, 12, kMotorola, true);
  temperature.scale = 0.01;
  temperature.offset = 250;
  const CanFrame frame = frame_of({0xC0, 0x06, 0xE0});
  EXPECT_EQ(extract_raw(layout(7, 1, kMotorola), frame), 1U);
  EXPECT_EQ(extract_raw(layout(6, 6, kMotorola), frame), 32U);
  EXPECT_NEAR(to_physical(temperature, extract_raw(temperature, frame)), 250.55, 1e-9);
  EXPECT_EQ(extract_raw(layout(7, 16, kMotorola), frame_of({0x12, 0x34})), 0x1234U);
  EXPECT_EQ(extract_raw(layout(7, 64, kMotorola), frame_of({1, 2, 3, 4, 5, 6, 7, 8})),
            0x0102030405060708U);
}

TEST(Signal, IntelStartIsTheLeastSignificantBit) {
  EXPECT_EQ(extract_raw(layout(0, 16, kIntel), frame_of({0x34, 0x12})), 0x1234U);
  EXPECT_EQ(extract_raw(layout(4, 12, kIntel), frame_of({0x3F, 0x12})), 0x123U);
  EXPECT_EQ(extract_raw(layout(0, 64, kIntel), frame_of({8, 7, 6, 5, 4, 3, 2, 1})),
            0x0102030405060708U);
}

TEST(Signal, InsertLeavesOtherBitsAlone) {
  CanFrame frame = frame_of({0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF});
  insert_raw(layout(3, 8, kMotorola), 0, frame);
  EXPECT_EQ(frame.data[0], 0xF0);
  EXPECT_EQ(frame.data[1], 0x0F);
  EXPECT_EQ(frame.data[2], 0xFF);
  insert_raw(layout(60, 4, kIntel), 0x15, frame);
  EXPECT_EQ(frame.data[7], 0x5F);
}

TEST(Signal, ReachesTheLastByteOfCanFd) {
  CanFrame frame;
  frame.fd = true;
  frame.dlc = 64;
  for (std::size_t k = 0; k < 64; ++k) frame.data[k] = static_cast<std::uint8_t>(k);
  EXPECT_EQ(extract_raw(layout(62 * 8, 16, kIntel), frame), 0x3F3EU);
  EXPECT_EQ(extract_raw(layout(62 * 8 + 7, 16, kMotorola), frame), 0x3E3FU);
  EXPECT_EQ(extract_raw(layout(7 * 8 + 4, 64, kIntel), frame), 0xF0E0D0C0B0A09080U);
  const FrameSignal far{.frame_id = 0, .signal = layout(64, 16, kIntel)};
  const FrameSignal near{.frame_id = 0, .signal = layout(48, 16, kIntel)};
  EXPECT_TRUE(needs_fd(far));
  EXPECT_FALSE(needs_fd(near));
  double value = 0;
  EXPECT_EQ(extract(far, frame, value), SignalError::kNone);
  EXPECT_EQ(value, 0x0908);
  frame.dlc = 8;
  EXPECT_EQ(extract(far, frame, value), SignalError::kShortFrame);
  EXPECT_EQ(extract(near, frame, value), SignalError::kNone);
}

TEST(Signal, SignExtension) {
  const Signal s = layout(0, 12, kIntel, true);
  EXPECT_EQ(to_physical(s, 0x800), -2048);
  EXPECT_EQ(to_physical(s, 0xFFF), -1);
  EXPECT_EQ(to_physical(s, 0x7FF), 2047);
  EXPECT_EQ(to_physical(layout(0, 64, kIntel, true), ~0ULL), -1);
  EXPECT_EQ(to_physical(layout(0, 1, kIntel, true), 1), -1);
}

TEST(Signal, FloatTypes) {
  Signal s = layout(7, 32, kMotorola);
  s.type = ValueType::kFloat32;
  EXPECT_EQ(check(s), SignalError::kNone);
  EXPECT_EQ(to_physical(s, std::bit_cast<std::uint32_t>(-1.5F)), -1.5);
  std::uint64_t raw = 0;
  EXPECT_EQ(to_raw(s, 0.25, raw), SignalError::kNone);
  EXPECT_EQ(raw, std::bit_cast<std::uint32_t>(0.25F));
  EXPECT_EQ(to_raw(s, 1e39, raw), SignalError::kNotRepresentable);
  s = layout(0, 64, kIntel);
  s.type = ValueType::kFloat64;
  EXPECT_EQ(to_physical(s, std::bit_cast<std::uint64_t>(1e-300)), 1e-300);
}

TEST(Signal, CheckRefusesByName) {
  EXPECT_EQ(check(layout(0, 0, kIntel)), SignalError::kLength);
  EXPECT_EQ(check(layout(0, 65, kIntel)), SignalError::kLength);
  EXPECT_EQ(check(layout(449, 64, kIntel)), SignalError::kOutsideFrame);
  EXPECT_EQ(check(layout(454, 64, kMotorola)), SignalError::kOutsideFrame);
  EXPECT_EQ(check(layout(512, 1, kIntel)), SignalError::kOutsideFrame);
  EXPECT_EQ(check(layout(65535, 64, kMotorola)), SignalError::kOutsideFrame);
  EXPECT_EQ(check(layout(56, 1, kMotorola)), SignalError::kNone);
  EXPECT_EQ(check(layout(504, 2, kMotorola)), SignalError::kOutsideFrame);
  Signal s = layout(0, 16, kIntel);
  s.type = ValueType::kFloat32;
  EXPECT_EQ(check(s), SignalError::kFloatLength);
  for (const double bad : {0.0, std::nan(""), HUGE_VAL}) {
    s = layout(0, 16, kIntel);
    s.scale = bad;
    EXPECT_EQ(check(s), SignalError::kScale);
  }
  s = layout(0, 16, kIntel);
  s.offset = std::nan("");
  EXPECT_EQ(check(s), SignalError::kScale);
  FrameSignal f;
  f.multiplexed = true;
  f.multiplexor.length = 0;
  EXPECT_EQ(check(f), SignalError::kLength);
}

TEST(Signal, BytesNeeded) {
  EXPECT_EQ(bytes_needed(layout(0, 8, kIntel)), 1);
  EXPECT_EQ(bytes_needed(layout(1, 8, kIntel)), 2);
  EXPECT_EQ(bytes_needed(layout(7, 8, kMotorola)), 1);
  EXPECT_EQ(bytes_needed(layout(6, 8, kMotorola)), 2);
  EXPECT_EQ(bytes_needed(layout(56, 1, kMotorola)), 8);
}

TEST(Signal, RawIsRefusedRatherThanSaturated) {
  std::uint64_t raw = 0;
  EXPECT_EQ(to_raw(layout(0, 8, kIntel), 255.4, raw), SignalError::kNone);
  EXPECT_EQ(raw, 255U);
  EXPECT_EQ(to_raw(layout(0, 8, kIntel), 256, raw), SignalError::kNotRepresentable);
  EXPECT_EQ(to_raw(layout(0, 8, kIntel), -1, raw), SignalError::kNotRepresentable);
  EXPECT_EQ(to_raw(layout(0, 8, kIntel, true), -128, raw), SignalError::kNone);
  EXPECT_EQ(raw, 0x80U);
  EXPECT_EQ(to_raw(layout(0, 8, kIntel, true), 128, raw), SignalError::kNotRepresentable);
  EXPECT_EQ(to_raw(layout(0, 64, kIntel), 1.8446744073709552e19, raw),
            SignalError::kNotRepresentable);
  EXPECT_EQ(to_raw(layout(0, 64, kIntel), std::ldexp(3, 62), raw), SignalError::kNone);
  EXPECT_EQ(raw, std::uint64_t{3} << 62);
  EXPECT_EQ(to_raw(layout(0, 8, kIntel), std::nan(""), raw),
            SignalError::kNotRepresentable);
}

TEST(Signal, ExtractSaysWhyThereIsNoValue) {
  FrameSignal s;
  s.frame_id = 0x123;
  s.signal = layout(8, 16, kIntel);
  s.multiplexed = true;
  s.multiplex_value = 3;
  s.multiplexor = layout(0, 4, kIntel);
  CanFrame frame = frame_of({0x03, 0x34, 0x12});
  double value = -1;
  EXPECT_EQ(extract(s, frame, value), SignalError::kOtherFrame);
  frame.id = 0x123;
  EXPECT_EQ(extract(s, frame, value), SignalError::kNone);
  EXPECT_EQ(value, 0x1234);
  frame.data[0] = 4;
  EXPECT_EQ(extract(s, frame, value), SignalError::kNotSelected);
  frame.dlc = 2;
  frame.data[0] = 3;
  EXPECT_EQ(extract(s, frame, value), SignalError::kShortFrame);
  frame.dlc = 0;
  EXPECT_EQ(extract(s, frame, value), SignalError::kShortFrame);
  frame.dlc = 8;
  for (bool CanFrame::*flag :
       {&CanFrame::extended, &CanFrame::remote, &CanFrame::error}) {
    CanFrame other = frame;
    other.*flag = true;
    EXPECT_EQ(extract(s, other, value), SignalError::kOtherFrame);
  }
  EXPECT_EQ(value, 0x1234);

  FrameSignal f;
  f.signal = layout(0, 32, kIntel);
  f.signal.type = ValueType::kFloat32;
  CanFrame nan = frame_of({0, 0, 0xC0, 0x7F});
  EXPECT_EQ(extract(f, nan, value), SignalError::kNotFinite);
}

TEST(Signal, InsertWritesTheMultiplexorToo) {
  FrameSignal s;
  s.signal = layout(8, 8, kIntel);
  s.multiplexed = true;
  s.multiplex_value = 5;
  s.multiplexor = layout(0, 4, kIntel);
  CanFrame frame = frame_of({0xF0});
  EXPECT_EQ(insert(s, 7, frame), SignalError::kNone);
  EXPECT_EQ(frame.data[0], 0xF5);
  EXPECT_EQ(frame.data[1], 7);
  EXPECT_EQ(insert(s, 700, frame), SignalError::kNotRepresentable);
  frame.dlc = 1;
  EXPECT_EQ(insert(s, 7, frame), SignalError::kShortFrame);
  frame.id = 1;
  EXPECT_EQ(insert(s, 7, frame), SignalError::kOtherFrame);
}

TEST(Signal, LimitsApplyOnlyWhenGiven) {
  Signal s;
  EXPECT_TRUE(within_limits(s, 1e9));
  s.maximum = 100;
  EXPECT_TRUE(within_limits(s, 100));
  EXPECT_FALSE(within_limits(s, 100.6));
  EXPECT_FALSE(within_limits(s, -0.6));
}

TEST(Signal, EitherReachingBeyondTheEighthByteNeedsCanFd) {
  FrameSignal s;
  s.signal = layout(0, 8, kIntel);
  s.multiplexor = layout(64, 8, kIntel);
  EXPECT_FALSE(needs_fd(s)) << "no multiplexor is used";
  s.multiplexed = true;
  EXPECT_TRUE(needs_fd(s));
  s.multiplexor = layout(56, 8, kIntel);
  EXPECT_FALSE(needs_fd(s));
}

TEST(Signal, FloatsComeBackAsTheyWereWritten) {
  std::uint64_t raw = 0;
  Signal s = layout(0, 64, kIntel);
  s.type = ValueType::kFloat64;
  s.scale = 0.5;
  s.offset = 3;
  EXPECT_EQ(check(s), SignalError::kNone);
  for (const double value : {-1e300, -0.125, 3.0, 7.25}) {
    ASSERT_EQ(to_raw(s, value, raw), SignalError::kNone);
    EXPECT_DOUBLE_EQ(to_physical(s, raw), value);
  }
  s = layout(0, 32, kIntel);
  s.type = ValueType::kFloat32;
  const double largest = static_cast<double>(std::numeric_limits<float>::max());
  ASSERT_EQ(to_raw(s, largest, raw), SignalError::kNone);
  EXPECT_EQ(to_physical(s, raw), largest);
  s = layout(0, 32, kIntel);
  s.type = ValueType::kFloat64;
  EXPECT_EQ(check(s), SignalError::kFloatLength);
}

TEST(Signal, LimitsOfOneKindOnlyAreNone) {
  Signal s;
  s.minimum = s.maximum = 5;
  EXPECT_TRUE(within_limits(s, 9));
  s.minimum = -5;
  EXPECT_TRUE(within_limits(s, -5));
  EXPECT_TRUE(within_limits(s, 5));
  EXPECT_FALSE(within_limits(s, 5.6));
  Signal byte = layout(0, 8, kIntel);
  byte.scale = 0.392157;  // of 255 steps, with as many digits as files have
  byte.maximum = 100;
  EXPECT_TRUE(within_limits(byte, to_physical(byte, 255)));
}

TEST(Signal, IsNotAvailableWhereTheRawNumberIsTheHighest) {
  const CanFrame frame = frame_of({0xFF, 0xFF, 0x7F});
  EXPECT_TRUE(is_highest_raw(layout(0, 16, kIntel), frame));
  EXPECT_FALSE(is_highest_raw(layout(8, 16, kIntel), frame));
  EXPECT_FALSE(is_highest_raw(layout(0, 16, kIntel, true), frame));
  EXPECT_TRUE(is_highest_raw(layout(8, 16, kIntel, true), frame));
  EXPECT_TRUE(is_highest_raw(layout(0, 8, kIntel), frame));
  EXPECT_FALSE(is_highest_raw(layout(0, 7, kIntel), frame)) << "a switch is no number";
  Signal real = layout(0, 32, kIntel);
  real.type = ValueType::kFloat32;
  EXPECT_FALSE(is_highest_raw(real, frame_of({0xFF, 0xFF, 0xFF, 0xFF})));
}

}  // namespace
}  // namespace wire
