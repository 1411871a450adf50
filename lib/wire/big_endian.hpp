// Unsigned integers, most significant byte first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace wire {

/// Writes the low bytes of `value` into all of `out` (at most 8 bytes).
constexpr void put_big_endian(std::uint64_t value, std::span<std::uint8_t> out) {
  for (std::size_t i = out.size(); i > 0; --i) {
    out[i - 1] = static_cast<std::uint8_t>(value);
    value >>= 8;
  }
}

/// Reads all of `data` (at most 8 bytes).
[[nodiscard]] constexpr std::uint64_t get_big_endian(std::span<const std::uint8_t> data) {
  std::uint64_t value = 0;
  for (const std::uint8_t byte : data) value = value << 8 | byte;
  return value;
}

}  // namespace wire
