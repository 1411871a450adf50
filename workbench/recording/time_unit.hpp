// Units of time as headers and cells name them.
#pragma once

#include <string>
#include <string_view>

#include "wire/calendar.hpp"

namespace workbench {

inline constexpr double kHourS = wire::kHourS;
inline constexpr double kDayS = wire::kDayS;

/// Seconds of a unit of time as headers name it ("s", "min", "ms", "Std"); 0: no unit of
/// time.
[[nodiscard]] double seconds_of_unit(std::string_view unit);

/// "500ms" and "0.5 s" as the number of seconds; anything else as it is.
[[nodiscard]] std::string in_seconds(const std::string& text);

/// Seconds of the unit that ends a name of several words: TimeMs, RelTime_ms; 0: none.
[[nodiscard]] double unit_in_name(std::string_view name);

/// Seconds for one of the last number of a clock of two whose form a header names: 1 of
/// mm:ss or m:ss.0, 60 of hh:mm. 0: no such form.
[[nodiscard]] double seconds_of_clock_form(std::string_view form);

}  // namespace workbench
