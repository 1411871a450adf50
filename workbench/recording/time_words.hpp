// Words in dates and times: months, weekdays, zones.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace workbench {

/// 1 … 12 of a word in small letters that begins with a month's name; 0: none.
[[nodiscard]] int month_named(std::string_view lower);

/// True for a weekday, short or long, in small letters.
[[nodiscard]] bool is_weekday(std::string_view lower);

/// Minutes east of UTC of a zone by its letters, small ones.
[[nodiscard]] std::optional<int> zone_named(std::string_view lower);

/// Letters that several zones share, the first of which zone_named() says.
struct OpenZone {
  std::string_view name;   ///< CST
  std::string_view means;  ///< "-06:00 or +08:00"
};
/// Nothing: the letters, small ones, are of one zone alone, or unknown.
[[nodiscard]] const OpenZone* open_zone(std::string_view lower);

/// A zone behind a time.
struct KnownZone {
  int minutes = 0;                 ///< east of UTC
  const OpenZone* open = nullptr;  ///< its letters are of others too
};
/// Whether times of both are of one reading: one offset, or standard and summer time of
/// one country (CST and CDT, GMT and BST), or neither is open.
[[nodiscard]] bool go_together(const KnownZone& a, const KnownZone& b);
/// "CST (-06:00 or +08:00)", "+02:00", for messages.
[[nodiscard]] std::string zone_text(const KnownZone& zone);

}  // namespace workbench
