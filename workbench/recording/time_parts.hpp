// Times whose numbers stand in columns of their own: year, month, day, hour, minute,
// second.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "workbench/recording/csv_layout.hpp"

namespace workbench {

inline constexpr std::size_t kClockParts = 3;
inline constexpr std::size_t kDateParts = 6;

/// The columns of hour and minute, side by side under such names in one of several
/// languages, and of second behind them or, by a name in full, anywhere, if there is one;
/// before them those of year, month and day where these stand side by side as well, in
/// any order. Or six columns without a header, or numbered from 1 to 6 under one name,
/// that begin as MATLAB's datevec does. In the order year … second; empty: none.
[[nodiscard]] std::vector<std::size_t> time_parts(const CsvLayout& layout);

/// Of numbers of time_parts(): a date is among them, a second.
[[nodiscard]] constexpr bool parts_have_date(std::size_t parts) {
  return parts > kClockParts;
}
[[nodiscard]] constexpr bool parts_have_second(std::size_t parts) {
  return parts % kClockParts == 0;
}

/// A column with a day, month or year before `parts`, which hold no date.
[[nodiscard]] std::optional<std::size_t> lone_day(const CsvLayout& layout,
                                                  const std::vector<std::size_t>& parts);

/// Numbers of time_parts() as written_time() reads them: 2026-05-13 14:30:00.25,
/// 14:30:00. Nothing where one is out of its range, or has decimals but the
/// last; hours alone may exceed a day. A year of two digits is 1970 to 2069.
[[nodiscard]] std::optional<std::string> time_of_parts(std::span<const double> parts);

}  // namespace workbench
