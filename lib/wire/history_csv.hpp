// Rows of the history as text: CSV with one line a window, for the gateway and for who
// pulled them. No heap or clock.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "wire/history_row.hpp"

namespace wire {

/// The header, with its line end: time (ISO 8601, UTC), verdict, flag 0 or 1, stick bands
/// with their 95 % intervals and detectable band in % of span, evidence in nats,
/// confidence in %, period in s.
[[nodiscard]] std::string_view history_csv_header();

inline constexpr std::size_t kMostHistoryLine = 160;
/// One line with its end; cells that are not available are empty. A mark is "restart".
/// Its length.
[[nodiscard]] std::size_t write_history_line(const HistoryRow& row,
                                             std::span<char, kMostHistoryLine> out);

}  // namespace wire
