// Dates that are written as a number, in a column beside the time of day.
#pragma once

#include <optional>
#include <string_view>

#include "workbench/recording/written_time.hpp"

namespace workbench {

/// Reads 20260514; 260514, which is day, month and year in an open order unless `order`
/// says it; 46156, a day of Excel's (2000 to 2099, perhaps with decimals that are zero).
/// Nothing: none of these. Alone each of them might be any number: ask only where the
/// column is one of dates.
[[nodiscard]] std::optional<WrittenTime> date_digits(
    std::string_view cell, std::optional<DateOrder> order = std::nullopt);

}  // namespace workbench
