// What a monitor has learned from windows that are over, as bytes that a restart survives
// and every target reads.
//
// Layout, big-endian, kMonitorBytes: alarm raised u8, its windows u16; windows alike u16,
// their verdict u8, with oscillation u8; evidence: windows and samples in single
// precision, then each rung in quarter nats i16; the valve from which the next window's
// search starts: dead band, slip jump ascending and descending, two time constants and
// unexplained share in single precision, motion u8, windows it is trusted for u8. No
// heap, clock or exceptions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "ident/monitor_memory.hpp"

namespace wire {

inline constexpr std::size_t kMonitorBytes =
    1 + 2 + 2 + 1 + 1 + 2 * 4 + 2 * ident::kLadderValves + 6 * 4 + 2;

[[nodiscard]] std::array<std::uint8_t, kMonitorBytes> encode_monitor(
    const ident::MonitorMemory& monitor);
/// False when a value is out of range; `monitor` is then not to be used.
[[nodiscard]] bool decode_monitor(std::span<const std::uint8_t, kMonitorBytes> data,
                                  ident::MonitorMemory& monitor);

}  // namespace wire
