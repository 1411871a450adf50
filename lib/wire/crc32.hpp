// CRC-32 of zip, PNG and Ethernet (reflected 0xEDB88320).
#pragma once

#include <cstdint>
#include <span>

namespace wire {

/// `before`: the CRC of what precedes `data`; 0 at the start. Linear, no table.
[[nodiscard]] constexpr std::uint32_t crc32(std::span<const std::uint8_t> data,
                                            std::uint32_t before = 0) {
  std::uint32_t crc = ~before;
  for (const std::uint8_t byte : data) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) {
      crc = crc >> 1 ^ (0xEDB88320U & (0U - (crc & 1U)));
    }
  }
  return ~crc;
}

}  // namespace wire
