// Words in dates and times: months, weekdays, zones.
#pragma once

#include <optional>
#include <string_view>

namespace workbench {

/// 1 … 12 of a word in small letters that begins with a month's name; 0: none.
[[nodiscard]] int month_named(std::string_view lower);

/// True for a weekday, short or long, in small letters.
[[nodiscard]] bool is_weekday(std::string_view lower);

/// Minutes east of UTC of a zone by its letters, small ones.
[[nodiscard]] std::optional<int> zone_named(std::string_view lower);

}  // namespace workbench
