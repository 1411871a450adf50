// Times that begin anew within one file: the logger was started again.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "workbench/recording/rows/row_table.hpp"

namespace workbench {

struct Restarts {
  std::vector<double> between;  ///< times, each after the last row of a run, s
  std::string note;
};

/// Makes `t`, seconds without a date, run on where it steps back to its beginning: each
/// run of rows comes behind the one before, kOutage intervals later, for how long nothing
/// was recorded nobody knows. `headed`: rows that stand behind the names of the columns
/// once more; they may begin earlier than the first row, too. Nothing, and `t` as it was,
/// where a step back is no restart: it leads elsewhere, the runs have stamps twice or
/// other intervals, repeat the values of the first one, or look like a counter that is
/// full (a minute, an hour, a day, 16 or 32 bits, equal runs without heads). O(n).
inline constexpr int kOutage = 11;
[[nodiscard]] std::optional<Restarts> run_on(std::vector<double>& t,
                                             std::span<const std::size_t> headed,
                                             const RowTable& table);

}  // namespace workbench
