// The first bytes of a frame of ISO 15765-2: what kind it is and how much it holds.
#pragma once

#include <cstddef>
#include <cstdint>

#include "wire/can_frame.hpp"

namespace wire::isotp {

inline constexpr std::uint8_t kSingle = 0;
inline constexpr std::uint8_t kFirst = 1;
inline constexpr std::uint8_t kConsecutive = 2;
inline constexpr std::uint8_t kFlowControl = 3;
inline constexpr std::uint8_t kContinue = 0;
inline constexpr std::uint8_t kWait = 1;
inline constexpr std::uint8_t kOverflow = 2;
inline constexpr std::size_t kInSingle = 7;
inline constexpr std::size_t kInFirst = 6;
inline constexpr std::size_t kInConsecutive = 7;

inline std::uint8_t kind_of(const CanFrame& frame) {
  return frame.data[0] >> 4;
}
inline std::uint8_t low_nibble(const CanFrame& frame) {
  return frame.data[0] & 0x0F;
}

/// A single frame that is complete and fits ISO 15765-2 for classic CAN.
inline bool is_single(const CanFrame& frame) {
  return kind_of(frame) == kSingle && low_nibble(frame) >= 1 &&
         low_nibble(frame) <= kInSingle && frame.dlc > low_nibble(frame);
}

}  // namespace wire::isotp
