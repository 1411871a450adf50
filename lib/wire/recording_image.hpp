// The bytes of a loop's recording window, as they are uploaded over UDS.
//
// Header, 24 bytes, big-endian: "SBRW", version u8 = 1, loop u8, flags u8 (bit 0: sp is
// recorded), reserved u8, samples u32, period µs u32, time of the first sample u64 ms
// since the epoch. Then, for each sample, u, y and sp as IEEE 754 single precision,
// big-endian; NaN: missing. No heap, clock or exceptions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace wire {

struct RecordingHeader {
  std::uint8_t loop = 0;  ///< 1 … 31
  bool has_setpoint = false;
  std::uint32_t samples = 0;    ///< 0 … kMostRecordingSamples
  std::uint32_t period_us = 0;  ///< µs, > 0
  std::uint64_t first_ms = 0;   ///< ms since the epoch
};

struct RecordingSample {
  float u = 0;
  float y = 0;
  float sp = 0;
};

inline constexpr std::size_t kRecordingHeaderBytes = 24;
inline constexpr std::size_t kRecordingSampleBytes = 12;
inline constexpr std::uint32_t kMostRecordingSamples = 1U << 20;

[[nodiscard]] constexpr std::uint32_t recording_bytes(std::uint32_t samples) {
  return static_cast<std::uint32_t>(kRecordingHeaderBytes +
                                    kRecordingSampleBytes * samples);
}

void encode_recording_header(const RecordingHeader& header,
                             std::span<std::uint8_t, kRecordingHeaderBytes> out);
/// False when these are not the bytes of a recording, or of another version.
[[nodiscard]] bool decode_recording_header(std::span<const std::uint8_t> data,
                                           RecordingHeader& out);
void encode_recording_sample(const RecordingSample& sample,
                             std::span<std::uint8_t, kRecordingSampleBytes> out);
[[nodiscard]] RecordingSample decode_recording_sample(
    std::span<const std::uint8_t, kRecordingSampleBytes> data);

}  // namespace wire
