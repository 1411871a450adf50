#include "workbench/recording/time_words.hpp"

#include <array>
#include <utility>

namespace workbench {
namespace {

using namespace std::string_view_literals;

constexpr std::array<std::pair<std::string_view, int>, 20> kMonths = {{
    {"jan", 1},        {"j\xC3\xA4n", 1}, {"j\xE4n", 1}, {"feb", 2},  {"mar", 3},
    {"m\xC3\xA4r", 3}, {"m\xE4r", 3},     {"mrz", 3},    {"maer", 3}, {"apr", 4},
    {"may", 5},        {"mai", 5},        {"jun", 6},    {"jul", 7},  {"aug", 8},
    {"sep", 9},        {"oct", 10},       {"okt", 10},   {"nov", 11}, {"dec", 12},
}};

constexpr std::array<std::pair<std::string_view, int>, 17> kZones = {{
    {"z", 0},
    {"utc", 0},
    {"gmt", 0},
    {"cet", 60},
    {"mez", 60},
    {"cest", 120},
    {"mesz", 120},
    {"est", -300},
    {"edt", -240},
    {"cst", -360},
    {"cdt", -300},
    {"mst", -420},
    {"mdt", -360},
    {"pst", -480},
    {"pdt", -420},
    {"wet", 0},
    {"bst", 60},
}};

}  // namespace

int month_named(std::string_view lower) {
  if (lower.starts_with("dez")) return 12;
  for (const auto& [name, month] : kMonths) {
    if (lower.starts_with(name)) return month;
  }
  return 0;
}

bool is_weekday(std::string_view lower) {
  for (const std::string_view day :
       {"mo"sv, "mon"sv, "tue"sv, "tues"sv, "wed"sv, "thu"sv, "thur"sv, "thurs"sv,
        "fri"sv, "sat"sv, "sun"sv, "di"sv, "mi"sv, "do"sv, "fr"sv, "sa"sv, "so"sv}) {
    if (lower == day) return true;
  }
  return lower.size() > 4 && (lower.ends_with("day") || lower.ends_with("tag") ||
                              lower == "mittwoch" || lower == "sonnabend");
}

std::optional<int> zone_named(std::string_view lower) {
  for (const auto& [name, minutes] : kZones) {
    if (lower == name) return minutes;
  }
  return std::nullopt;
}

}  // namespace workbench
