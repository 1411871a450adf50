#include "workbench/recording/time_words.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "workbench/recording/letters.hpp"

namespace workbench {
namespace {

// Beginnings, of which a longer one stands before the shorter; letters of UTF-8 folded.
// English, German, French, Spanish, Italian, Portuguese, Dutch, Swedish, Polish, Turkish,
// Finnish, Russian.
constexpr auto kMonths = std::to_array<std::pair<std::string_view, int>>({
    {"marras", 11}, {"jan", 1},   {"j\xE4n", 1}, {"gen", 1},   {"ene", 1},    {"sty", 1},
    {"oca", 1},     {"tammi", 1}, {"янв", 1},    {"feb", 2},   {"fev", 2},    {"lut", 2},
    {"sub", 2},     {"helmi", 2}, {"фев", 2},    {"mar", 3},   {"m\xE4r", 3}, {"mrz", 3},
    {"mrt", 3},     {"maer", 3},  {"maalis", 3}, {"мар", 3},   {"apr", 4},    {"avr", 4},
    {"abr", 4},     {"kwi", 4},   {"nis", 4},    {"huhti", 4}, {"апр", 4},    {"may", 5},
    {"mai", 5},     {"maj", 5},   {"mag", 5},    {"mei", 5},   {"touko", 5},  {"мая", 5},
    {"май", 5},     {"jun", 6},   {"juin", 6},   {"giu", 6},   {"cze", 6},    {"haz", 6},
    {"kesa", 6},    {"июн", 6},   {"jul", 7},    {"juil", 7},  {"lug", 7},    {"lip", 7},
    {"tem", 7},     {"heina", 7}, {"июл", 7},    {"aug", 8},   {"aou", 8},    {"ago", 8},
    {"sie", 8},     {"elo", 8},   {"авг", 8},    {"sep", 9},   {"set", 9},    {"wrz", 9},
    {"eyl", 9},     {"syys", 9},  {"сен", 9},    {"oct", 10},  {"okt", 10},   {"ott", 10},
    {"out", 10},    {"paz", 10},  {"eki", 10},   {"loka", 10}, {"окт", 10},   {"nov", 11},
    {"lis", 11},    {"kas", 11},  {"ноя", 11},   {"dec", 12},  {"dez", 12},   {"dic", 12},
    {"gru", 12},    {"ara", 12},  {"joulu", 12}, {"дек", 12},
});

constexpr std::array<std::pair<std::string_view, int>, 36> kZones = {{
    {"z", 0},      {"utc", 0},    {"gmt", 0},    {"cet", 60},   {"mez", 60},
    {"cest", 120}, {"mesz", 120}, {"est", -300}, {"edt", -240}, {"cst", -360},
    {"cdt", -300}, {"mst", -420}, {"mdt", -360}, {"pst", -480}, {"pdt", -420},
    {"wet", 0},    {"bst", 60},   {"ut", 0},     {"west", 60},  {"eet", 120},
    {"oez", 120},  {"eest", 180}, {"oesz", 180}, {"msk", 180},  {"sast", 120},
    {"sgt", 480},  {"hkt", 480},  {"awst", 480}, {"jst", 540},  {"kst", 540},
    {"aest", 600}, {"aedt", 660}, {"nzst", 720}, {"nzdt", 780}, {"brt", -180},
    {"hst", -600},
}};

constexpr std::array kOpenZones = std::to_array<OpenZone>({
    {"CST", "-06:00 or +08:00"},
    {"CDT", "-05:00 or -04:00"},
    {"EST", "-05:00 or +10:00"},
    {"EDT", "-04:00 or +11:00"},
    {"MST", "-07:00 or +08:00"},
    {"PST", "-08:00 or +08:00"},
    {"BST", "+01:00 or +06:00"},
});

constexpr int kHourMin = 60;

// Where summer time follows the standard time of an open zone, or the other way round.
bool is_other_time_of(const KnownZone& open, int minutes) {
  if (open.open->name == "BST") return minutes == 0;
  const bool standard = open.open->name[1] == 'S';
  return minutes == open.minutes + (standard ? kHourMin : -kHourMin);
}

}  // namespace

int month_named(std::string_view lower) {
  const std::string plain = folded(lower);
  for (const auto& [name, month] : kMonths) {
    if (plain.starts_with(name)) return month;
  }
  return 0;
}

bool is_weekday(std::string_view lower) {
  constexpr std::string_view kShort =
      "mo|mon|tue|tues|wed|thu|thur|thurs|fri|sat|sun|di|mi|do|fr|sa|so";
  if (is_one_of(lower, kShort)) return true;
  return lower.size() > 4 && (lower.ends_with("day") || lower.ends_with("tag") ||
                              lower == "mittwoch" || lower == "sonnabend");
}

const OpenZone* open_zone(std::string_view lower) {
  for (const OpenZone& zone : kOpenZones) {
    if (lower_case(zone.name) == lower) return &zone;
  }
  return nullptr;
}

bool go_together(const KnownZone& a, const KnownZone& b) {
  if (a.minutes == b.minutes && a.open == b.open) return true;
  if (a.open == nullptr && b.open == nullptr) return true;
  if (a.open != nullptr && b.open != nullptr) {
    return a.open->name[0] == b.open->name[0];
  }
  const KnownZone& open = a.open != nullptr ? a : b;
  const int other = a.open != nullptr ? b.minutes : a.minutes;
  return other == open.minutes || is_other_time_of(open, other);
}

std::string zone_text(const KnownZone& zone) {
  if (zone.open != nullptr) {
    return std::string(zone.open->name) + " (" + std::string(zone.open->means) + ")";
  }
  const int minutes = std::abs(zone.minutes);
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%c%02d:%02d", zone.minutes < 0 ? '-' : '+',
                minutes / kHourMin, minutes % kHourMin);
  return text.data();
}

std::optional<int> zone_named(std::string_view lower) {
  for (const auto& [name, minutes] : kZones) {
    if (lower == name) return minutes;
  }
  return std::nullopt;
}

}  // namespace workbench
