// Units of time as headers and cells name them.
#pragma once

#include <string_view>

namespace workbench {

/// Seconds of a unit of time as headers name it ("s", "min", "ms", "Std"); 0: no unit of
/// time.
[[nodiscard]] double seconds_of_unit(std::string_view unit);

/// Likewise of the unit that ends a name of several words: TimeMs, RelTime_ms; 0: none.
[[nodiscard]] double unit_in_name(std::string_view name);

}  // namespace workbench
