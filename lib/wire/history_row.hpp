// A row of the history: what one window of a loop said, 32 bytes with their own CRC-32.
//
// Big-endian: sequence u16 (of its ring, never 0 in both sequence and CRC), verdict u8,
// flags u8 (bit 0: the flag was raised), time u32 s since the epoch, period u16 0.1 s,
// confidence u8 0.5 %, reserved u8, stick band ascending value, low, high u16, descending
// value, low, high u16 (0.01 % of span), detectable band u16, evidence i16 (0.1 nat),
// CRC-32 of all before it. All ones: not available. A row with the verdict 0 is a mark:
// the loop was reset, or another configuration began. An upload (35 00 44 with 0x100 +
// loop as address) has "SBHI", version u8 = 1, loop u8, rows u16, then the rows of all
// rings, empty ones too, in no order. No heap, clock or exceptions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "wire/diagnostics.hpp"
#include "wire/loop_memory.hpp"

namespace wire {

struct HistoryRow {
  std::uint16_t sequence = 0;
  LoopVerdict verdict = LoopVerdict::kNotEvaluated;
  bool flag = false;
  std::uint32_t time_s = 0;  ///< newest sample of the window, since the epoch
  double period_s = kNotAvailable;
  double confidence_pct = kNotAvailable;
  StrokeValues stick_band_pct;  ///< % of span, as all that follows
  StrokeValues stick_band_low_pct;
  StrokeValues stick_band_high_pct;
  double detectable_band_pct = kNotAvailable;
  double evidence_nats = kNotAvailable;
};

/// Where its bands are, in the order in which they are kept and told.
template <class Row>
constexpr auto bands_of(Row& row) {
  return std::array{&row.stick_band_pct.ascending,
                    &row.stick_band_low_pct.ascending,
                    &row.stick_band_high_pct.ascending,
                    &row.stick_band_pct.descending,
                    &row.stick_band_low_pct.descending,
                    &row.stick_band_high_pct.descending,
                    &row.detectable_band_pct};
}

inline constexpr std::size_t kHistoryRowBytes = 32;
inline constexpr std::size_t kHistoryHeaderBytes = 8;
inline constexpr std::uint32_t kHistoryAddress = 0x100;  ///< of an upload, and the loop

/// The newest window of a status, without sequence and time.
[[nodiscard]] HistoryRow history_row(const LoopStatus& status);

void encode_history_row(const HistoryRow& row,
                        std::span<std::uint8_t, kHistoryRowBytes> out);
/// False: empty, damaged, or no verdict.
[[nodiscard]] bool decode_history_row(
    std::span<const std::uint8_t, kHistoryRowBytes> data, HistoryRow& row);

/// The same of sequence, verdict, flag and time alone: a fraction of the cost.
[[nodiscard]] bool decode_history_head(
    std::span<const std::uint8_t, kHistoryRowBytes> data, HistoryRow& row);

/// Reads all rows of `rings` that are whole into `out`, which has room for them, by time;
/// a window that several rings have comes once. How many there are.
[[nodiscard]] std::size_t read_history(std::span<const std::uint8_t> rings,
                                       std::span<HistoryRow> out);

void encode_history_header(std::uint8_t loop, std::uint16_t rows,
                           std::span<std::uint8_t, kHistoryHeaderBytes> out);
/// The number of rows; 0 when these are not the bytes of a history of this version.
[[nodiscard]] std::uint16_t decode_history_header(
    std::span<const std::uint8_t, kHistoryHeaderBytes> data);

}  // namespace wire
