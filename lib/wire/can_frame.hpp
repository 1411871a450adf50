// One classic CAN frame, as value.
#pragma once

#include <array>
#include <cstdint>

namespace wire {

inline constexpr std::uint32_t kMaxStandardId = 0x7FF;
inline constexpr std::uint32_t kMaxExtendedId = 0x1FFFFFFF;
inline constexpr std::uint8_t kMaxClassicLength = 8;

struct CanFrame {
  std::uint32_t id = 0;   ///< 0 … 0x7FF, or 0 … 0x1FFFFFFF when extended; error class
  bool extended = false;  ///< 29-bit identifier
  bool remote = false;    ///< RTR: `dlc` counts the bytes asked for, data is void
  bool error = false;     ///< error frame of the driver, not from the wire
  std::uint8_t dlc = 0;   ///< bytes, 0 … 8
  std::array<std::uint8_t, kMaxClassicLength> data{};  ///< beyond dlc: zero

  friend constexpr bool operator==(const CanFrame&, const CanFrame&) = default;
};

static_assert(sizeof(CanFrame) <= 16, "queues hold frames by the hundred");

/// True when the fields are in the ranges stated above.
[[nodiscard]] constexpr bool is_valid(const CanFrame& frame) {
  return frame.id <= (frame.extended || frame.error ? kMaxExtendedId : kMaxStandardId) &&
         frame.dlc <= kMaxClassicLength && !(frame.extended && frame.error);
}

}  // namespace wire
