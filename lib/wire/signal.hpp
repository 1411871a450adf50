// A signal inside a CAN frame, with the semantics of DBC files.
//
// `start` of a little-endian (Intel) signal is the position of its least significant
// bit: byte start/8, bit start%8. `start` of a big-endian (Motorola) signal is the
// position of its MOST significant bit in the same numbering; from there the signal
// runs down to bit 0 of that byte and on at bit 7 of the next one (sawtooth):
//   byte 0: 7 6 5 4 3 2 1 0   byte 1: 15 14 13 12 11 10 9 8   …
// A 16-bit big-endian value in bytes 0 and 1 starts at 7, not at 0 or 15.
//
// physical = raw · scale + offset. All calls cost O(length), keep no state, allocate
// nothing; a definition is checked once with check(), not on every frame.
#pragma once

#include <cstdint>

#include "wire/can_frame.hpp"

namespace wire {

enum class ByteOrder : std::uint8_t { kLittleEndian, kBigEndian };
enum class ValueType : std::uint8_t { kInteger, kFloat32, kFloat64 };

struct Signal {
  std::uint16_t start = 0;   ///< bit position as above, 0 … 511; beyond 63: of CAN FD
  std::uint16_t length = 1;  ///< bits, 1 … 64; 32 or 64 for the float types
  ByteOrder byte_order = ByteOrder::kLittleEndian;
  ValueType type = ValueType::kInteger;
  bool is_signed = false;  ///< two's complement; without meaning for float types
  double scale = 1;        ///< physical units per raw step, not 0, finite
  double offset = 0;       ///< physical value of raw 0, finite
  double minimum = 0;      ///< physical; minimum ≥ maximum means no limits
  double maximum = 0;      ///< physical
};

/// A signal and the frame that carries it: all that is needed to read it from a bus.
struct FrameSignal {
  std::uint32_t frame_id = 0;
  bool extended = false;
  std::uint32_t ignored = 0;  ///< bits of the identifier that may be any; 0 in frame_id
  Signal signal = {};
  bool multiplexed = false;           ///< present only while `multiplexor` reads …
  std::uint32_t multiplex_value = 0;  ///< … this raw value
  Signal multiplexor = {};            ///< meaningful when `multiplexed`
};

enum class SignalError : std::uint8_t {
  kNone,
  kLength,            ///< length not 1 … 64
  kOutsideFrame,      ///< a bit lies beyond the 64th byte
  kFloatLength,       ///< float type and length other than 32 (float) or 64 (double)
  kScale,             ///< scale 0 or not finite, or offset not finite
  kOtherFrame,        ///< the frame has another identifier, or is remote or error
  kShortFrame,        ///< the frame has fewer bytes than the signal needs
  kNotSelected,       ///< the multiplexor reads another value
  kNotFinite,         ///< the frame holds a NaN or an infinity
  kNotRepresentable,  ///< the value to insert does not fit
};

/// A sentence fragment: what is wrong.
[[nodiscard]] const char* describe(SignalError error);

/// Checks a definition against the longest frame; the other calls require kNone.
[[nodiscard]] SignalError check(const Signal& signal);
[[nodiscard]] SignalError check(const FrameSignal& signal);

/// Bytes a frame must have to hold `signal`, 1 … 64; beyond 8 it has to be CAN FD.
[[nodiscard]] std::uint8_t bytes_needed(const Signal& signal);

/// Only a CAN FD frame is long enough.
[[nodiscard]] bool needs_fd(const FrameSignal& signal);

/// The bits of the signal, right-aligned, without sign extension. Requires
/// frame.dlc ≥ bytes_needed(signal).
[[nodiscard]] std::uint64_t extract_raw(const Signal& signal, const CanFrame& frame);

/// Whether the raw number is the highest there is, which is how J1939 (unsigned) and NMEA
/// 2000 (signed, too) write "not available". Of less than eight bits none is. As
/// extract_raw.
[[nodiscard]] bool is_highest_raw(const Signal& signal, const CanFrame& frame);

/// Replaces the bits of the signal; `raw` beyond `length` bits is ignored.
void insert_raw(const Signal& signal, std::uint64_t raw, CanFrame& frame);

/// Physical value of raw bits, and back. to_raw() rounds to the nearest step and
/// returns kNotRepresentable rather than saturate; minimum and maximum play no part.
[[nodiscard]] double to_physical(const Signal& signal, std::uint64_t raw);
[[nodiscard]] SignalError to_raw(const Signal& signal, double physical,
                                 std::uint64_t& raw);

/// True when no limits are given or `physical` lies within them, or half a raw step
/// outside: limits are written with fewer digits than raw · scale has.
[[nodiscard]] bool within_limits(const Signal& signal, double physical);

/// Reads the signal from a frame off the bus: kOtherFrame, kShortFrame, kNotSelected,
/// kNotFinite, or kNone with the physical value in `physical`.
[[nodiscard]] SignalError extract(const FrameSignal& signal, const CanFrame& frame,
                                  double& physical);

/// Writes the value, and the multiplexor if there is one, into a frame of that
/// identifier with enough bytes.
[[nodiscard]] SignalError insert(const FrameSignal& signal, double physical,
                                 CanFrame& frame);

}  // namespace wire
