#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "feed.hpp"
#include "hal/slcan.hpp"
#include "require.hpp"
#include "wire/candump.hpp"
#include "wire/signal.hpp"

namespace fuzz {
namespace {

constexpr std::size_t kLayoutBytes = 8;

wire::Signal signal_of(std::uint8_t start, std::uint8_t length, std::uint8_t choice) {
  constexpr std::array<double, 4> kScales = {1, 0.01, -2.5e7, 1e300};
  constexpr std::array<double, 4> kOffsets = {0, -40, 1e9, 1e-300};
  wire::Signal signal;
  signal.start = start;
  signal.length = length;
  signal.byte_order =
      (choice & 1) != 0 ? wire::ByteOrder::kBigEndian : wire::ByteOrder::kLittleEndian;
  signal.type = static_cast<wire::ValueType>((choice >> 1 & 3) % 3);
  signal.is_signed = (choice & 8) != 0;
  signal.scale = kScales[choice >> 4 & 3];
  signal.offset = kOffsets[choice >> 6];
  return signal;
}

// The first bytes of the input; its signal may be one that no file would be let through
// with.
wire::FrameSignal layout_of(std::string_view bytes) {
  const auto byte = [&](std::size_t k) { return static_cast<std::uint8_t>(bytes[k]); };
  wire::FrameSignal layout;
  layout.signal = signal_of(byte(0), byte(1), byte(2));
  if ((byte(3) & 4) != 0) layout.signal.start += 256;  // of CAN FD
  layout.extended = (byte(3) & 1) != 0;
  layout.multiplexed = (byte(3) & 2) != 0;
  layout.frame_id = layout.extended ? 0x18FF1000 : 0x18F;
  layout.multiplexor = signal_of(byte(4), byte(5), byte(6) & 9);
  layout.multiplex_value = byte(7);
  return layout;
}

void write_and_read(const wire::CandumpLine& line) {
  std::array<char, wire::kMaxCandumpLine> text;
  const std::size_t length = wire::format_candump(line, text);
  if (length == 0) return;
  wire::CandumpLine again;
  require(wire::parse_candump({text.data(), length}, again).ok(),
          "a written line that can be read");
  require(again.frame == line.frame && again.time_ns == line.time_ns &&
              again.interface == line.interface,
          "a line that reads as it was written");
}

void write_and_read(const wire::CanFrame& frame) {
  std::array<char, hal::kMaxSlcanLine> text;
  const std::size_t length = hal::write_slcan(frame, text);
  require(length > 0 || frame.error || frame.fd, "a frame that can be written");
  wire::CanFrame again;
  require(length == 0 ||
              (hal::parse_slcan({text.data(), length - 1}, again) && again == frame),
          "a frame that reads as it was written");
}

bool read_line(std::string_view text, wire::CanFrame& frame) {
  if (text.starts_with('(')) {
    wire::CandumpLine line;
    const wire::CandumpStatus status = wire::parse_candump(text, line);
    require(status.ok() == (status.column == 0), "a column for each error");
    require(status.column <= text.size() + 1, "a column of the line");
    if (!status.ok()) return false;
    write_and_read(line);
    frame = line.frame;
  } else if (!hal::parse_slcan(text, frame)) {
    return false;
  }
  require(wire::is_valid(frame), "a valid frame");
  write_and_read(frame);
  return true;
}

void insert_and_extract(const wire::FrameSignal& layout, wire::CanFrame frame,
                        double value) {
  const std::uint64_t raw = wire::extract_raw(layout.signal, frame);
  wire::insert_raw(layout.signal, raw, frame);
  require(wire::extract_raw(layout.signal, frame) == raw, "the bits that were inserted");
  if (wire::insert(layout, value, frame) != wire::SignalError::kNone) return;
  double again = 0;
  const wire::SignalError error = wire::extract(layout, frame, again);
  // The multiplexor may lie within the signal; then the last one written wins.
  if (layout.multiplexed || error == wire::SignalError::kNotFinite) return;
  require(error == wire::SignalError::kNone, "a value that was inserted");
  const bool rounded = layout.signal.type == wire::ValueType::kInteger;
  const double step = rounded ? 0.51 * std::abs(layout.signal.scale) : 0;
  const double digits = 1e-6 * (std::abs(value) + std::abs(layout.signal.offset));
  require(std::abs(again - value) <= step + digits, "the value that was inserted");
}

void extract(const wire::FrameSignal& layout, const wire::CanFrame& frame) {
  double value = 0;
  if (wire::extract(layout, frame, value) != wire::SignalError::kNone) return;
  require(std::isfinite(value), "a finite value");
  insert_and_extract(layout, frame, value);
}

}  // namespace

Outcome feed_frames(std::string_view bytes) {
  if (bytes.size() < kLayoutBytes) return Outcome::kRefused;
  const wire::FrameSignal layout = layout_of(bytes);
  bytes.remove_prefix(kLayoutBytes);
  const bool good = wire::check(layout) == wire::SignalError::kNone;
  bool any = false;
  while (!bytes.empty()) {
    const std::string_view line = bytes.substr(0, bytes.find('\n'));
    bytes.remove_prefix(std::min(line.size() + 1, bytes.size()));
    wire::CanFrame frame;
    if (!read_line(line, frame) || !good) continue;
    any = true;
    extract(layout, frame);
    frame.id = layout.frame_id;
    frame.extended = layout.extended;
    frame.remote = frame.error = false;
    extract(layout, frame);
  }
  return any ? Outcome::kAccepted : Outcome::kRefused;
}

}  // namespace fuzz
