// Dates as spreadsheets keep them: days as a number, a format that shows them.
#pragma once

#include <string>
#include <string_view>

namespace workbench {

/// What a number format shows.
enum class SheetDate { kNone, kDate, kDateTime, kClock, kDuration };

/// The kind of a built-in format (ECMA-376 part 1, 18.8.30).
[[nodiscard]] SheetDate built_in_date(int format);

/// The kind of a format code: `dd.mm.yyyy hh:mm`, `[h]:mm:ss`, `0.00`, ...
[[nodiscard]] SheetDate date_of_code(std::string_view code);

/// A number of days, to the millisecond: 2026-05-13 14:30:00.250 for a date, 14:30:00.250
/// for a time of day, s for a duration. Dates count from 30 December 1899, or from 1904.
/// Days outside of 1900 to 9999, and those of no date, as the number itself.
[[nodiscard]] std::string sheet_date(double days, SheetDate kind, bool from_1904);

}  // namespace workbench
