#include "workbench/recording/time_unit.hpp"

#include <array>
#include <string>
#include <utility>

#include "workbench/recording/cell_reader.hpp"
#include "workbench/recording/letters.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {

namespace {

// Words of one unit, and its seconds.
constexpr auto kUnits = std::to_array<std::pair<std::string_view, double>>({
    {"s|sec|secs|second|seconds|sek|sekunden|sekunde|secondes|segundos|\u0441|"
     "\u0441\u0435\u043A|\u79D2|\uCD08",
     1},
    {"ms|msec|millis|millisec|millisecond|milliseconds|millisekunden|\u043C\u0441|"
     "\u6BEB\u79D2|\u30DF\u30EA\u79D2",
     1e-3},
    {"us|\xC2\xB5s|\xCE\xBCs|usec|micros|microsec|microseconds|\u043C\u043A\u0441", 1e-6},
    {"ns", 1e-9},
    {"min|mn|mins|minute|minutes|minuten|minutos|minuti|\u043C\u0438\u043D|\u5206|"
     "\u5206\u949F|\uBD84",
     60},
    {"h|hr|hours|std|stunden|hrs|hour|heures|horas|ore|stunde|\u0447|\u5C0F\u65F6|\u65F6|"
     "\u6642",
     3600},
    {"d|days", 86400},
});

}  // namespace

double seconds_of_unit(std::string_view unit) {
  std::string lower = lower_case(unit.substr(0, 16));
  if (!lower.empty() && lower.back() == '.') lower.pop_back();
  for (const auto& [names, seconds] : kUnits) {
    if (is_one_of(lower, names)) return seconds;
  }
  return 0;
}

std::string in_seconds(const std::string& text) {
  const std::size_t behind = text.find_first_not_of("0123456789.+-eE ");
  if (behind == std::string::npos) return text;
  const std::string_view before = trimmed(std::string_view(text).substr(0, behind));
  const double unit_s = seconds_of_unit(std::string_view(text).substr(behind));
  const std::optional<double> value = wire::number_of<double>(before);
  if (!(unit_s > 0) || !value) return text;
  constexpr int kAllDigits = 15;
  return number(*value * unit_s, kAllDigits);
}

double unit_in_name(std::string_view name) {
  std::size_t at = name.size();
  while (at > 0 && (is_small(name[at - 1]) || is_capital(name[at - 1]))) {
    --at;
    if (at > 0 && is_capital(name[at]) && is_small(name[at - 1])) break;
  }
  return at > 0 ? seconds_of_unit(name.substr(at)) : 0;
}

double seconds_of_clock_form(std::string_view form) {
  const std::string lower = lower_case(form.substr(0, 16));
  const std::size_t colon = lower.find(':');
  if (colon == std::string::npos || colon == 0) return 0;
  const std::string_view front = std::string_view(lower).substr(0, colon);
  const std::string_view back = std::string_view(lower).substr(colon + 1);
  const auto all = [](std::string_view text, char letter) {
    return !text.empty() && text.find_first_not_of(letter) == std::string_view::npos;
  };
  if (all(front, 'm') || front == "min") {
    const bool seconds = all(back.substr(0, back.find_first_of(".,")), 's');
    return seconds || back == "sec" || back == "sek" ? 1 : 0;
  }
  return all(front, 'h') && (all(back, 'm') || back == "min") ? 60 : 0;
}

}  // namespace workbench
