// What a loop remembers over a restart beside its DTCs: what the newest window said, the
// alarm and the evidence of earlier windows, as bytes.
//
// Layout, big-endian, kLoopMemoryBytes: a window was judged u8, CRC-32 of the
// configuration that it holds for u32, end of the newest window and time of the evidence
// i64 ms since the epoch each, last change of the verdict i64; verdict of the newest
// window and of the newest that was due u8 each, samples of that u16, suspect effect u8;
// the numbers of kept_numbers() and the stick bands told last as IEEE 754 single
// precision, NaN: not available; the monitor (monitor_bytes.hpp). No heap, clock or
// exceptions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "ident/monitor_memory.hpp"
#include "wire/diagnostics.hpp"
#include "wire/monitor_bytes.hpp"

namespace wire {

/// Low and high of a stick band, % of span; NaN: none.
using BandInterval = std::array<double, 2>;

struct LoopMemory {
  bool judged = false;  ///< false: all that follows means nothing
  /// Of span, sampling and signals: memory of other ones is not taken over.
  std::uint32_t configuration = 0;
  std::int64_t ended_ms = 0;     ///< newest sample of the newest window, since the epoch
  std::int64_t evidence_ms = 0;  ///< the evidence has faded up to then, since the epoch
  LoopVerdict standing = LoopVerdict::kNotEvaluated;  ///< of the newest due window
  std::uint16_t standing_samples = 0;                 ///< its samples
  /// Ascending and descending stick band that was told last.
  std::array<BandInterval, 2> told_bands = {
      {{kNotAvailable, kNotAvailable}, {kNotAvailable, kNotAvailable}}};
  ident::MonitorMemory monitor;
};

inline constexpr std::size_t kKeptNumbers = 18;
/// The numbers of a status that its newest window made.
using KeptNumber = double& (*)(LoopStatus&);
[[nodiscard]] std::span<const KeptNumber, kKeptNumbers> kept_numbers();

inline constexpr std::size_t kLoopMemoryBytes =
    1 + 4 + 3 * 8 + 1 + 1 + 2 + 1 + 4 * (kKeptNumbers + 4) + kMonitorBytes;

/// `status` has the numbers of the newest window and its verdict.
void encode_loop_memory(const LoopMemory& memory, const LoopStatus& status,
                        std::span<std::uint8_t, kLoopMemoryBytes> out);
/// False when a value is out of range. The verdict of the window, the numbers and the
/// last change go into `status`; what is published is left to who decides on it.
[[nodiscard]] bool decode_loop_memory(
    std::span<const std::uint8_t, kLoopMemoryBytes> data, LoopMemory& memory,
    LoopStatus& status);

}  // namespace wire
