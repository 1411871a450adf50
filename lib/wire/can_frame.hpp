// One CAN frame, classic or CAN FD, as value.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace wire {

inline constexpr std::uint32_t kMaxStandardId = 0x7FF;
inline constexpr std::uint32_t kMaxExtendedId = 0x1FFFFFFF;
inline constexpr std::uint8_t kMaxClassicLength = 8;
inline constexpr std::uint8_t kMaxFdLength = 64;

struct CanFrame {
  std::uint32_t id = 0;   ///< 0 … 0x7FF, or 0 … 0x1FFFFFFF when extended; error class
  bool extended = false;  ///< 29-bit identifier
  bool remote = false;    ///< RTR: `dlc` counts the bytes asked for, data is void
  bool error = false;     ///< error frame of the driver, not from the wire
  std::uint8_t dlc = 0;   ///< bytes, 0 … 8, or as is_fd_length() says
  std::array<std::uint8_t, kMaxFdLength> data{};  ///< beyond dlc: zero
  bool fd = false;                                ///< CAN FD: up to 64 bytes; not remote
  bool brs = false;  ///< of CAN FD: the data came at the higher bit rate
  bool esi = false;  ///< of CAN FD: the sender is error passive

  friend constexpr bool operator==(const CanFrame&, const CanFrame&) = default;
};

static_assert(sizeof(CanFrame) <= 76, "queues hold frames by the hundred");

/// Lengths that a CAN FD frame can have.
[[nodiscard]] constexpr bool is_fd_length(std::size_t bytes) {
  return bytes <= kMaxClassicLength || (bytes <= 24 && bytes % 4 == 0) || bytes == 32 ||
         bytes == 48 || bytes == 64;
}

/// True when the fields are in the ranges stated above.
[[nodiscard]] constexpr bool is_valid(const CanFrame& frame) {
  return frame.id <= (frame.extended || frame.error ? kMaxExtendedId : kMaxStandardId) &&
         (frame.fd ? is_fd_length(frame.dlc) && !frame.remote && !frame.error
                   : frame.dlc <= kMaxClassicLength && !frame.brs && !frame.esi) &&
         !(frame.extended && frame.error);
}

}  // namespace wire
