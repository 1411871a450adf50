// Which time column belongs to which signal where each signal has its own.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "workbench/recording/csv_layout.hpp"

namespace workbench {

/// Of each of the columns `signals` the column of its times; nothing where all rows have
/// one time. Told by the names where each signal has a time of its name (FIC101.PV and
/// FIC101.PV Time); else by the side: where times stand before the first signal, each has
/// the next time to its left, otherwise the next one to its right; at least two of the
/// times must then stand beside a number on that side. Times that rest (the bounds of a
/// query) do not count. Of no signals: an empty list where two times stand before
/// numbers.
[[nodiscard]] std::optional<std::vector<std::size_t>> own_times(
    const CsvLayout& layout, const std::vector<std::size_t>& signals);

}  // namespace workbench
