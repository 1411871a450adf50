#include "workbench/recording/times_of_rows.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>

namespace workbench {
namespace {

constexpr double kDayS = 86400;

std::chrono::year_month_day date_of(std::int32_t day) {
  return std::chrono::sys_days(std::chrono::days(day));
}

}  // namespace

std::string date_text(std::int32_t day) {
  constexpr std::array<const char*, 12> kNames = {
      "January", "February", "March",     "April",   "May",      "June",
      "July",    "August",   "September", "October", "November", "December"};
  const std::chrono::year_month_day date = date_of(day);
  return std::to_string(static_cast<unsigned>(date.day())) + ' ' +
         kNames[static_cast<unsigned>(date.month()) - 1] + ' ' +
         std::to_string(static_cast<int>(date.year()));
}

TimesOfRows::Doubt doubt_of_zones(const std::string& a, const std::string& b) {
  return {"times of one zone, or of zones with one meaning", a + " beside " + b,
          "export the times in one zone, or with offsets, as 14:30:00+08:00"};
}

TimesOfRows::Doubt doubt_of_days(const std::string& found) {
  return {"times with one meaning", found,
          "say which after the name: --time \"NAME [s]\" or --time \"NAME [d]\""};
}

TimesOfRows::Doubt doubt_of_clock(const std::string& found) {
  return {"times with one meaning", found,
          "say after the name whether the last two are seconds or minutes: --time "
          "\"NAME [s]\" or --time \"NAME [min]\""};
}

ClockTime clock_time(const TimesOfRows& times, double t) {
  const double seconds = times.origin_seconds + t;
  const double days = std::floor(seconds / kDayS);
  return {times.origin_day + static_cast<std::int32_t>(days), seconds - days * kDayS};
}

std::string clock_text(const TimesOfRows& times, double t) {
  if (!times.dated) return {};
  const double to_ms = std::round((t + 60.0 * times.zone_min) * 1e3) / 1e3;
  const ClockTime at = clock_time(times, to_ms);
  const std::chrono::year_month_day date = date_of(at.day);
  const auto ms = static_cast<int>(std::min(std::round(at.seconds * 1e3), 86399999.0));
  const int whole = ms / 1000;
  std::array<char, 80> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02u-%02uT%02d:%02d:%02d",
                static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                static_cast<unsigned>(date.day()), whole / 3600, whole / 60 % 60,
                whole % 60);
  std::string out = text.data();
  if (ms % 1000 > 0) {
    std::snprintf(text.data(), text.size(), ".%03d", ms % 1000);
    out += text.data();
  }
  if (times.zoned) {
    out += times.zone_min == 0 ? "Z" : zone_text({times.zone_min, nullptr});
  }
  return out;
}

std::string zone_written(const TimesOfRows& times) {
  if (!times.dated) return {};
  if (!times.zoned) return times.zone_word;
  return times.open_zone != nullptr ? std::string(times.open_zone->name)
                                    : zone_text(times.zone());
}

}  // namespace workbench
