// Identifiers and values as SAE J1939 lays them out.
#pragma once

#include <cstdint>

#include "wire/signal.hpp"

namespace wire::j1939 {

// Parts of a 29-bit identifier.
inline constexpr std::uint32_t kPriority = 0x1C000000;
inline constexpr std::uint32_t kDestination = 0xFF00;  ///< where is_to_one()
inline constexpr std::uint32_t kSourceAddress = 0xFF;

inline constexpr std::uint32_t kMaxPgn = 0x3FFFF;
inline constexpr std::uint8_t kFirstErrorCode = 0xFB;  ///< of the highest byte, J1939-71

/// Whether frames of the parameter group go to one device.
[[nodiscard]] constexpr bool is_to_one(std::uint32_t pgn) {
  return (pgn & 0xFF00) < 0xF000;
}

/// The parameter group of a 29-bit identifier, without a destination.
[[nodiscard]] constexpr std::uint32_t pgn_of(std::uint32_t id) {
  const std::uint32_t pgn = id >> 8 & kMaxPgn;
  return is_to_one(pgn) ? pgn & ~0xFFU : pgn;
}

/// Unsigned whole bytes: from kFirstErrorCode on in the highest there is no value.
[[nodiscard]] constexpr bool has_error_codes(const Signal& signal) {
  return signal.type == ValueType::kInteger && !signal.is_signed &&
         signal.length % 8 == 0;
}

}  // namespace wire::j1939
