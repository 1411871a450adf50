// Laws of the codecs, over random layouts, frames and lines.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <string>

#include "wire/candump.hpp"
#include "wire/dbc.hpp"
#include "wire/decimal.hpp"
#include "wire/signal.hpp"

namespace wire {
namespace {

CanFrame any_frame() {
  CanFrame frame;
  const int kind = *rc::gen::inRange(0, 3);
  frame.extended = kind == 1;
  frame.error = kind == 2;
  frame.id = *rc::gen::inRange<std::uint32_t>(
      0, (kind == 0 ? kMaxStandardId : kMaxExtendedId) + 1);
  frame.fd = kind != 2 && *rc::gen::arbitrary<bool>();
  frame.brs = frame.fd && *rc::gen::arbitrary<bool>();
  frame.esi = frame.fd && *rc::gen::arbitrary<bool>();
  frame.dlc = *rc::gen::inRange<std::uint8_t>(0, 9);
  if (frame.fd) frame.dlc = *rc::gen::element<std::uint8_t>(0, 3, 8, 12, 24, 48, 64);
  frame.remote = kind != 2 && !frame.fd && *rc::gen::arbitrary<bool>();
  for (std::size_t i = 0; i < frame.dlc && !frame.remote; ++i) {
    frame.data[i] = *rc::gen::arbitrary<std::uint8_t>();
  }
  return frame;
}

// Any layout that fits the longest frame.
Signal any_layout() {
  Signal s;
  s.byte_order =
      *rc::gen::arbitrary<bool>() ? ByteOrder::kBigEndian : ByteOrder::kLittleEndian;
  s.start = *rc::gen::inRange<std::uint16_t>(0, 512);
  const unsigned first = s.byte_order == ByteOrder::kBigEndian
                             ? s.start / 8U * 8U + 7U - s.start % 8U
                             : s.start;
  s.length =
      static_cast<std::uint16_t>(*rc::gen::inRange(1U, std::min(64U, 512U - first) + 1));
  s.is_signed = *rc::gen::arbitrary<bool>();
  return s;
}

CanFrame full_frame() {
  CanFrame frame;
  frame.fd = true;
  frame.dlc = kMaxFdLength;
  for (std::uint8_t& byte : frame.data) byte = *rc::gen::arbitrary<std::uint8_t>();
  return frame;
}

std::uint64_t mask(unsigned length) {
  return ~std::uint64_t{0} >> (64 - length);
}

// Walks the signal bit by bit as the DBC describes it.
std::uint64_t walked(const Signal& s, const CanFrame& frame) {
  std::uint64_t value = 0;
  unsigned bit = s.start;
  for (unsigned i = 0; i < s.length; ++i) {
    const std::uint64_t one = frame.data[bit / 8] >> (bit % 8) & 1U;
    if (s.byte_order == ByteOrder::kLittleEndian) {
      value |= one << i;
      ++bit;
    } else {
      value = value << 1 | one;
      bit = bit % 8 == 0 ? bit + 15 : bit - 1;
    }
  }
  return value;
}

RC_GTEST_PROP(WireLaw, ExtractAgreesWithWalkingTheBits, ()) {
  const Signal s = any_layout();
  const CanFrame frame = full_frame();
  RC_ASSERT(check(s) == SignalError::kNone);
  RC_ASSERT(extract_raw(s, frame) == walked(s, frame));
}

RC_GTEST_PROP(WireLaw, ExtractAfterInsertIsTheSameAndNothingElseChanges, ()) {
  const Signal s = any_layout();
  const CanFrame before = full_frame();
  const std::uint64_t raw = *rc::gen::arbitrary<std::uint64_t>() & mask(s.length);
  CanFrame frame = before;
  insert_raw(s, raw, frame);
  RC_ASSERT(extract_raw(s, frame) == raw);
  insert_raw(s, extract_raw(s, before), frame);
  RC_ASSERT(frame == before);
}

RC_GTEST_PROP(WireLaw, BytesBeyondThoseNeededPlayNoPart, ()) {
  const Signal s = any_layout();
  CanFrame frame = full_frame();
  const std::uint64_t raw = extract_raw(s, frame);
  for (std::size_t i = bytes_needed(s); i < frame.data.size(); ++i) frame.data[i] = 0;
  RC_ASSERT(extract_raw(s, frame) == raw);
  CanFrame cut = frame;
  cut.data[bytes_needed(s) - 1U] =
      static_cast<std::uint8_t>(~cut.data[bytes_needed(s) - 1U]);
  RC_ASSERT(extract_raw(s, cut) != raw);
}

RC_GTEST_PROP(WireLaw, PhysicalValuesSurviveTheTrip, ()) {
  Signal s = any_layout();
  s.length = std::min<std::uint16_t>(s.length, 40);
  s.scale = *rc::gen::element(1.0, 0.01, -0.5, 1e-3, 100.0);
  s.offset = *rc::gen::element(0.0, -40.0, 250.0, 1e4);
  const std::uint64_t raw = *rc::gen::arbitrary<std::uint64_t>() & mask(s.length);
  std::uint64_t back = 0;
  RC_ASSERT(to_raw(s, to_physical(s, raw), back) == SignalError::kNone);
  RC_ASSERT(back == raw);
}

RC_GTEST_PROP(WireLaw, MultiplexedSignalsAreSeenOnlyOnTheirPage, (std::uint8_t page)) {
  FrameSignal s;
  s.signal.start = 8;
  s.signal.length = 16;
  s.multiplexed = true;
  s.multiplexor.length = 8;
  s.multiplex_value = *rc::gen::arbitrary<std::uint8_t>();
  CanFrame frame = full_frame();
  frame.data[0] = page;
  double value = 0;
  const SignalError error = extract(s, frame, value);
  RC_ASSERT((error == SignalError::kNone) == (page == s.multiplex_value));
}

RC_GTEST_PROP(WireLaw, CandumpLinesReadBackAsWritten, ()) {
  CandumpLine line;
  line.time_ns = *rc::gen::inRange<std::int64_t>(0, 9'000'000'000'000'000'000);
  if (*rc::gen::arbitrary<bool>()) line.time_ns -= line.time_ns % 1000;
  // Of the length that the kernel allows: a nonempty container may be one longer.
  const std::string drawn = *rc::gen::resize(
      15,
      rc::gen::nonEmpty(rc::gen::container<std::string>(rc::gen::inRange('!', '\x7F'))));
  const std::string interface = drawn.substr(0, 15);
  line.interface = interface;
  line.frame = any_frame();
  std::array<char, kMaxCandumpLine> text;
  const std::size_t length = format_candump(line, text);
  RC_ASSERT(length > 0U);
  CandumpLine back;
  RC_ASSERT(parse_candump({text.data(), length}, back).ok());
  RC_ASSERT(back.time_ns == line.time_ns);
  RC_ASSERT(back.interface == line.interface);
  RC_ASSERT(back.frame == line.frame);
  for (std::size_t room = 0; room < length; ++room) {
    RC_ASSERT(format_candump(line, {text.data(), room}) == 0U);
  }
}

RC_GTEST_PROP(WireLaw, DbcReadsBackAsWritten, ()) {
  Signal s = any_layout();
  const bool extended = *rc::gen::arbitrary<bool>();
  const auto id = *rc::gen::inRange<std::uint32_t>(
      0, (extended ? kMaxExtendedId : kMaxStandardId) + 1);
  s.scale = *rc::gen::element(1.0, 0.01, -0.5, 1e-3, 100.0);
  s.offset = *rc::gen::element(0.0, -40.0, 273.15);
  std::array<char, 200> text;
  const int length =
      std::snprintf(text.data(), text.size(),
                    "BO_ %u M: 64 X\n SG_ S : %u|%u@%d%c (%.17g,%.17g) [0|0] \"\" X\n",
                    id | (extended ? 0x80000000U : 0U), unsigned{s.start},
                    unsigned{s.length}, s.byte_order == ByteOrder::kLittleEndian ? 1 : 0,
                    s.is_signed ? '-' : '+', s.scale, s.offset);
  std::array<DbcMessage, 1> messages;
  std::array<DbcSignal, 1> signals;
  Dbc dbc(messages, signals);
  RC_ASSERT(dbc.parse({text.data(), static_cast<std::size_t>(length)}).ok());
  FrameSignal found;
  RC_ASSERT(dbc.find("M.S", found).ok());
  RC_ASSERT(found.frame_id == id);
  RC_ASSERT(found.extended == extended);
  RC_ASSERT(found.signal.start == s.start);
  RC_ASSERT(found.signal.length == s.length);
  RC_ASSERT(found.signal.byte_order == s.byte_order);
  RC_ASSERT(found.signal.is_signed == s.is_signed);
  RC_ASSERT(std::abs(found.signal.scale - s.scale) <= 1e-15 * std::abs(s.scale));
  RC_ASSERT(std::abs(found.signal.offset - s.offset) <= 1e-15 * std::abs(s.offset));
}

RC_GTEST_PROP(WireLaw, DecimalsAgreeWithTheStandardLibrary, ()) {
  const auto mantissa =
      *rc::gen::inRange<std::int64_t>(-999'999'999'999'999, 999'999'999'999'999);
  const int exponent = *rc::gen::inRange(-22, 1);
  const std::string text = std::to_string(mantissa) + "e" + std::to_string(exponent);
  double expected = 0;
  std::from_chars(text.data(), text.data() + text.size(), expected);
  double value = 0;
  RC_ASSERT(parse_decimal(text, value));
  RC_ASSERT(value == expected);
}

}  // namespace
}  // namespace wire
