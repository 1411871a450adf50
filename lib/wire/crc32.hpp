// CRC-32 of zip, PNG and Ethernet (reflected 0xEDB88320).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace wire {

inline constexpr std::size_t kChecksumBytes = 4;  ///< of a CRC-32 in an image

/// The CRC of one byte after nothing, without the complements.
inline constexpr auto kCrc32Table = [] {
  std::array<std::uint32_t, 256> table{};
  for (std::size_t byte = 0; byte < table.size(); ++byte) {
    auto crc = static_cast<std::uint32_t>(byte);
    for (int bit = 0; bit < 8; ++bit) {
      crc = crc >> 1 ^ (0xEDB88320U & (0U - (crc & 1U)));
    }
    table[byte] = crc;
  }
  return table;
}();

/// `before`: the CRC of what precedes `data`; 0 at the start. Linear, one look into a
/// table of 1 KiB a byte: years of history are read at a start, and a flag waits.
[[nodiscard]] constexpr std::uint32_t crc32(std::span<const std::uint8_t> data,
                                            std::uint32_t before = 0) {
  std::uint32_t crc = ~before;
  for (const std::uint8_t byte : data) {
    crc = crc >> 8 ^ kCrc32Table[(crc ^ byte) & 0xFFU];
  }
  return ~crc;
}

}  // namespace wire
