// Zones, and the one behind a clock time.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace workbench {

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

struct WrittenZone {
  std::size_t length = 0;  ///< bytes read
  std::optional<int>
      minutes;               ///< east of UTC; nothing: there is no zone, or it is unknown
  std::string_view unknown;  ///< its name: IST, Europe/Berlin
  const OpenZone* open = nullptr;  ///< its letters alone say it, and others share them
};

/// Reads at the front of `text` +02:00, -0400, Z and the names of zone_named(), with an
/// offset behind (GMT+0200) and a remark in brackets ([Europe/Berlin]). Other names of
/// three to five capitals, as those that several zones share, and regions are unknown. No
/// zone: nothing read. nullopt: a word that is none, or an offset beyond 14 hours.
[[nodiscard]] std::optional<WrittenZone> written_zone(std::string_view text);

/// Whether clock times behind which a file writes `a` and another one `b` may be
/// compared: the same letters, or offsets that go_together(). "": no zone, local time.
[[nodiscard]] bool one_clock(std::string_view a, std::string_view b);
/// "CST (-06:00 or +08:00)", "+02:00", "IST (not known)", "no zone", for messages.
[[nodiscard]] std::string zone_words(std::string_view written);

}  // namespace workbench
