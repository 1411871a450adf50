#include "workbench/recording/time_unit.hpp"

#include <array>
#include <string>
#include <utility>

#include "workbench/recording/letters.hpp"

namespace workbench {

namespace {

constexpr auto kUnits = std::to_array<std::pair<std::string_view, double>>({
    {"s", 1},
    {"sec", 1},
    {"secs", 1},
    {"second", 1},
    {"seconds", 1},
    {"sek", 1},
    {"sekunden", 1},
    {"ms", 1e-3},
    {"msec", 1e-3},
    {"millis", 1e-3},
    {"millisec", 1e-3},
    {"millisecond", 1e-3},
    {"milliseconds", 1e-3},
    {"millisekunden", 1e-3},
    {"us", 1e-6},
    {"\xC2\xB5s", 1e-6},
    {"\xCE\xBCs", 1e-6},
    {"usec", 1e-6},
    {"micros", 1e-6},
    {"microsec", 1e-6},
    {"microseconds", 1e-6},
    {"ns", 1e-9},
    {"min", 60},
    {"mn", 60},
    {"mins", 60},
    {"minute", 60},
    {"minutes", 60},
    {"minuten", 60},
    {"h", 3600},
    {"hr", 3600},
    {"hours", 3600},
    {"std", 3600},
    {"stunden", 3600},
    {"hrs", 3600},
    {"hour", 3600},
    {"heures", 3600},
    {"horas", 3600},
    {"ore", 3600},
    {"stunde", 3600},
    {"sekunde", 1},
    {"secondes", 1},
    {"segundos", 1},
    {"minutos", 60},
    {"minuti", 60},
    {"\u043C\u0441", 1e-3},
    {"\u043C\u043A\u0441", 1e-6},
    {"\u0441", 1},
    {"\u0441\u0435\u043A", 1},
    {"\u043C\u0438\u043D", 60},
    {"\u0447", 3600},
    {"\u6BEB\u79D2", 1e-3},
    {"\u30DF\u30EA\u79D2", 1e-3},
    {"\u79D2", 1},
    {"\u5206", 60},
    {"\u5206\u949F", 60},
    {"\u5C0F\u65F6", 3600},
    {"\u65F6", 3600},
    {"\u6642", 3600},
    {"\uCD08", 1},
    {"\uBD84", 60},
    {"d", 86400},
    {"days", 86400},
});

}  // namespace

double seconds_of_unit(std::string_view unit) {
  std::string lower = lower_case(unit.substr(0, 16));
  if (!lower.empty() && lower.back() == '.') lower.pop_back();
  for (const auto& [name, seconds] : kUnits) {
    if (lower == name) return seconds;
  }
  return 0;
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
