#include "workbench/recording/sheet_date.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace workbench {
namespace {

constexpr std::int64_t kDayMs = 86'400'000;
constexpr double kLastDay = 2'958'465;  // 31 December 9999
constexpr int k1904 = 1462;             // days from one origin to the other

struct Letters {
  bool day = false;  // or year
  bool month_or_minute = false;
  bool clock = false;
  bool elapsed = false;
};

bool is_elapsed(std::string_view bracket) {
  return !bracket.empty() &&
         bracket.find_first_not_of("hHmMsS") == std::string_view::npos;
}

// The letters of the first section, without literal text and colours.
Letters letters_of(std::string_view code) {
  Letters out;
  for (std::size_t i = 0; i < code.size() && code[i] != ';'; ++i) {
    switch (code[i]) {
      case '"':
        i = std::min(code.find('"', i + 1), code.size());
        break;
      case '\\':
      case '_':
      case '*':
        ++i;
        break;
      case '[': {
        const std::size_t end = std::min(code.find(']', i), code.size());
        out.elapsed = out.elapsed || is_elapsed(code.substr(i + 1, end - i - 1));
        i = end;
        break;
      }
      case 'y':
      case 'Y':
      case 'd':
      case 'D':
        out.day = true;
        break;
      case 'm':
      case 'M':
        out.month_or_minute = true;
        break;
      case 'h':
      case 'H':
      case 's':
      case 'S':
        out.clock = true;
        break;
      default:
        break;
    }
  }
  return out;
}

}  // namespace

SheetDate built_in_date(int format) {
  if (format >= 14 && format <= 17) return SheetDate::kDate;
  if (format == 22) return SheetDate::kDateTime;
  if ((format >= 27 && format <= 36) || (format >= 50 && format <= 58)) {
    return SheetDate::kDate;  // of East Asian languages
  }
  if ((format >= 18 && format <= 21) || format == 45 || format == 47) {
    return SheetDate::kClock;
  }
  return format == 46 ? SheetDate::kDuration : SheetDate::kNone;
}

SheetDate date_of_code(std::string_view code) {
  if (code == "General") return SheetDate::kNone;
  const Letters letters = letters_of(code);
  if (letters.elapsed) return SheetDate::kDuration;
  if (letters.day) return letters.clock ? SheetDate::kDateTime : SheetDate::kDate;
  if (letters.clock) return SheetDate::kClock;
  return letters.month_or_minute ? SheetDate::kDate : SheetDate::kNone;
}

std::string sheet_date(double days, SheetDate kind, bool from_1904) {
  std::array<char, 80> text{};
  const bool known = days >= 0 && days < kLastDay;
  if (kind == SheetDate::kNone || !known) {
    std::snprintf(text.data(), text.size(), "%.15g", days);
    return text.data();
  }
  const auto ms = static_cast<std::int64_t>(std::llround(days * kDayMs));
  if (kind == SheetDate::kDuration) {
    std::snprintf(text.data(), text.size(), "%lld.%03d",
                  static_cast<long long>(ms / 1000), static_cast<int>(ms % 1000));
    return text.data();
  }
  const int of_day = static_cast<int>(ms % kDayMs);
  std::array<char, 48> clock{};
  std::snprintf(clock.data(), clock.size(), "%02d:%02d:%02d.%03d", of_day / 3'600'000,
                of_day / 60'000 % 60, of_day / 1000 % 60, of_day % 1000);
  // A date under a format that shows the time alone is a date all the same.
  if (kind == SheetDate::kClock && ms < kDayMs) return clock.data();
  using namespace std::chrono;
  const sys_days origin = sys_days(year(1899) / December / 30);
  const year_month_day date(origin +
                            std::chrono::days(ms / kDayMs + (from_1904 ? k1904 : 0)));
  const bool midnight = kind == SheetDate::kDate && of_day == 0;
  std::snprintf(text.data(), text.size(), "%04d-%02u-%02u%s%s",
                static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                static_cast<unsigned>(date.day()), midnight ? "" : " ",
                midnight ? "" : clock.data());
  return text.data();
}

}  // namespace workbench
