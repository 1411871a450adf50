#include "workbench/recording/time_unit.hpp"

#include <array>
#include <string>
#include <utility>

#include "workbench/recording/letters.hpp"

namespace workbench {

double seconds_of_unit(std::string_view unit) {
  std::string lower = lower_case(unit.substr(0, 16));
  if (!lower.empty() && lower.back() == '.') lower.pop_back();
  constexpr std::array<std::pair<std::string_view, double>, 34> kUnits = {{
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
      {"mins", 60},
      {"minute", 60},
      {"minutes", 60},
      {"minuten", 60},
      {"h", 3600},
      {"hr", 3600},
      {"hours", 3600},
      {"std", 3600},
      {"stunden", 3600},
      {"d", 86400},
      {"days", 86400},
  }};
  for (const auto& [name, seconds] : kUnits) {
    if (lower == name) return seconds;
  }
  return 0;
}

}  // namespace workbench
