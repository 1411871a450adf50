// Lines of `candump -L` and `candump -l` logs, in and out:
//   (1436509052.249713) vcan0 044#2A366C2BBA
//   (1436509052.249713) vcan0 044##12A366C2BBA
// Three hex digits of identifier are a standard frame, eight an extended one, eight
// with 0x20000000 an error frame; `#R` or `#R4` a remote frame; `##` and a digit of flags
// (1 bit rate switch, 2 error state) a CAN FD frame of up to 64 bytes, or an error frame,
// which some converters write so; a last field R or
// T (direction) is ignored. What candump shows on a screen with `-t a`, `-t z` or `-t d`
// is read too; a length of two digits is that of a CAN FD frame, of four of CAN XL:
//   (1436509052.249713)  vcan0  044   [5]  2A 36 6C 2B BA
//   (1436509052.249713)  vcan0  044  [05]  2A 36 6C 2B BA
// Without times (`-t` not given) or with dates (`-t A`) it is not. Frames of CAN XL are
// recognised as such and refused with an error of their own, so that a caller can count
// them. No state, no allocation; every call is linear in the line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "wire/can_frame.hpp"

namespace wire {

enum class CandumpError : std::uint8_t {
  kNone,
  kTimeStart,   ///< no '(' at the start
  kTime,        ///< not seconds with up to nine decimals
  kTimeEnd,     ///< no ") " after the time
  kInterface,   ///< no interface name of 1 to 15 characters
  kIdentifier,  ///< not 3 or 8 hex digits, or out of range
  kData,        ///< not pairs of hex digits
  kTooLong,     ///< more than eight bytes of a classic frame
  kFdFlags,     ///< no hex digit of flags after `##`
  kFdLength,    ///< not a length that CAN FD has
  kTrailing,    ///< something other than R or T after the frame
  kXlFrame,     ///< well-formed start of a CAN XL frame: not supported
};

/// What stands at the place where `error` was found, for "expected …" messages.
[[nodiscard]] const char* expected_at(CandumpError error);

struct CandumpStatus {
  CandumpError error = CandumpError::kNone;
  std::size_t column = 0;  ///< of the error, in bytes from 1; 0 without error
  [[nodiscard]] constexpr bool ok() const { return error == CandumpError::kNone; }
};

struct CandumpLine {
  std::int64_t time_ns = 0;    ///< ns, as logged (usually since the Unix epoch), ≥ 0
  std::string_view interface;  ///< points into the parsed line
  CanFrame frame;
  bool relative = false;  ///< on a screen, with less than ten digits: -t z or -t d
};

inline constexpr std::size_t kMaxInterfaceName = 15;
/// Longest text format_candump() writes.
inline constexpr std::size_t kMaxCandumpLine = 192;

/// Parses one line without its line end (a final '\r' and blanks are accepted).
/// `out` is complete on success and for kXlFrame all but the frame.
[[nodiscard]] CandumpStatus parse_candump(std::string_view line, CandumpLine& out);

/// Writes `line` as candump -L does, microseconds unless nanoseconds are needed, no
/// line end. Returns the characters written, 0 when `out` is too small, a field out
/// of range, or the interface name empty, too long or not printable.
[[nodiscard]] std::size_t format_candump(const CandumpLine& line, std::span<char> out);

}  // namespace wire
