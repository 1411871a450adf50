#include "workbench/recording/time_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <string_view>

#include "workbench/recording/columns/line_table.hpp"
#include "workbench/recording/letters.hpp"

namespace workbench {
namespace {

enum class TimePart : std::size_t { kYear, kMonth, kDay, kHour, kMinute, kSecond };

// Year to second; MM is what its place says.
constexpr std::array<std::string_view, kDateParts> kWords = {
    "year|years|yr|yyyy|yy|jahr|annee|ano|anio|anno|jaar|ar|rok|年|연|년",
    "month|months|mon|mm|mo|monat|mois|mes|mese|maand|manad|miesiac|月|월",
    "day|days|dd|d|tag|jour|dia|giorno|dag|dzien|日|일",
    "hour|hours|hr|hrs|hh|h|stunde|stunden|std|heure|heures|hora|horas|ora|ore|uur|"
    "timme|godzina|时|時|小时|시",
    "minute|minutes|min|mins|mm|mi|m|minuten|minuto|minutos|minuti|minuut|minuta|分|"
    "分钟|분",
    "second|seconds|sec|secs|ss|s|sekunde|sekunden|sek|seconde|secondes|segundo|"
    "segundos|secondo|secondi|sekund|sekunda|秒|초"};

constexpr double kFirstYear = 1970;
constexpr double kLastYear = 2100;
// Of the number at each place of a date and time; years are looked at apart.
constexpr std::array<double, kDateParts> kLeast = {0, 1, 1, 0, 0, 0};
constexpr std::array<double, kDateParts> kMost = {kLastYear, 12, 31, 23, 59, 59};

bool holds_numbers(const LayoutColumn& column) {
  return column.content == Content::kNumber;
}

bool is_named(const LayoutColumn& column, TimePart part) {
  if (!holds_numbers(column) || column.name.pieces.empty()) return false;
  return is_one_of(folded(column.name.pieces.back()),
                   kWords[static_cast<std::size_t>(part)]);
}

// The columns of `parts` in that order, from `first` on.
bool are_named(const std::vector<LayoutColumn>& columns, std::size_t first,
               std::initializer_list<TimePart> parts) {
  if (first + parts.size() > columns.size()) return false;
  return std::ranges::all_of(parts, [&columns, &first](TimePart part) {
    return is_named(columns[first++], part);
  });
}

// Year, month and day among the columns but those of the clock.
std::vector<std::size_t> date_among(const std::vector<LayoutColumn>& columns,
                                    const std::vector<std::size_t>& clock) {
  constexpr auto kYear = TimePart::kYear;
  constexpr auto kMonth = TimePart::kMonth;
  constexpr auto kDay = TimePart::kDay;
  for (std::size_t i = 0; i + kClockParts <= columns.size(); ++i) {
    const bool overlap = std::ranges::any_of(
        clock, [i](std::size_t c) { return c >= i && c < i + kClockParts; });
    if (overlap) continue;
    if (are_named(columns, i, {kYear, kMonth, kDay})) return {i, i + 1, i + 2};
    if (are_named(columns, i, {kDay, kMonth, kYear})) return {i + 2, i + 1, i};
    if (are_named(columns, i, {kMonth, kDay, kYear})) return {i + 2, i, i + 1};
  }
  return {};
}

bool is_whole(double value) {
  return value == std::floor(value);
}

// Letters alone, and names of statistics, may be of anything.
bool is_in_full(const LayoutColumn& column) {
  const std::string word = folded(column.name.pieces.back());
  return word.size() > 1 && word != "std";
}

// Min beside Max is the least of a time.
bool stands_for_least(const std::vector<LayoutColumn>& columns, std::size_t at) {
  const auto last_piece = [](const LayoutColumn& column) {
    return column.name.pieces.empty() ? "" : folded(column.name.pieces.back());
  };
  return last_piece(columns[at]) == "min" &&
         std::ranges::any_of(columns, [&](const LayoutColumn& column) {
           const std::string word = last_piece(column);
           return word == "max" || word == "maximum" || word == "mean" || word == "avg";
         });
}

// Hour and minute, from `first` on, whose first row is one.
bool are_hour_and_minute(const std::vector<LayoutColumn>& columns, std::size_t first) {
  if (!are_named(columns, first, {TimePart::kHour, TimePart::kMinute})) return false;
  const LayoutColumn& hours = columns[first];
  const LayoutColumn& minutes = columns[first + 1];
  if (!is_in_full(hours) || !is_in_full(minutes)) return false;
  if (stands_for_least(columns, first + 1)) return false;
  const std::optional<double> hour = wire::number_of<double>(hours.first);
  const std::optional<double> minute = wire::number_of<double>(minutes.first);
  return hour && minute && *hour >= 0 && is_whole(*hour) && *minute >= 0 && *minute < 60;
}

// Hour, minute and, if there is one, second.
std::vector<std::size_t> clock_among(const std::vector<LayoutColumn>& columns) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (are_named(columns, i, {TimePart::kHour, TimePart::kMinute, TimePart::kSecond})) {
      return {i, i + 1, i + 2};
    }
  }
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (!are_hour_and_minute(columns, i)) continue;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (is_named(columns[k], TimePart::kSecond) && is_in_full(columns[k])) {
        return {i, i + 1, k};
      }
    }
    return {i, i + 1};
  }
  return {};
}

// In the first row; the year rests.
bool begins_as_datevec(std::span<const LayoutColumn> columns) {
  for (std::size_t i = 0; i < kDateParts; ++i) {
    const std::optional<double> value = wire::number_of<double>(columns[i].first);
    const bool last = i + 1 == kDateParts;
    if (!holds_numbers(columns[i]) || !value || *value < kLeast[i] ||
        *value >= kMost[i] + 1 || !(last || is_whole(*value))) {
      return false;
    }
  }
  return *wire::number_of<double>(columns[0].first) >= kFirstYear && columns[0].rests();
}

// Time1 … Time6, one name.
bool are_numbered(std::span<const LayoutColumn> columns) {
  const std::string& first = columns[0].name.key;
  if (first.size() < 2) return false;
  for (std::size_t i = 0; i < kDateParts; ++i) {
    const std::string& key = columns[i].name.key;
    if (key.size() != first.size() || key.back() != static_cast<char>('1' + i) ||
        key.compare(0, key.size() - 1, first, 0, first.size() - 1) != 0) {
      return false;
    }
  }
  return true;
}

std::vector<std::size_t> nameless_datevec(const CsvLayout& layout) {
  const std::span<const LayoutColumn> columns = layout.columns;
  for (std::size_t i = 0; i + kDateParts <= columns.size(); ++i) {
    const auto six = columns.subspan(i, kDateParts);
    const bool bare = layout.header.empty() && i == 0;
    if ((bare || are_numbered(six)) && begins_as_datevec(six)) {
      return {i, i + 1, i + 2, i + 3, i + 4, i + 5};
    }
  }
  return {};
}

}  // namespace

std::vector<std::size_t> time_parts(const CsvLayout& layout) {
  const std::vector<std::size_t> clock = clock_among(layout.columns);
  if (clock.empty()) return nameless_datevec(layout);
  std::vector<std::size_t> out = date_among(layout.columns, clock);
  out.insert(out.end(), clock.begin(), clock.end());
  return out;
}

std::optional<std::size_t> lone_day(const CsvLayout& layout,
                                    const std::vector<std::size_t>& parts) {
  for (std::size_t i = parts.front(); i-- > 0;) {
    for (const TimePart part : {TimePart::kDay, TimePart::kMonth, TimePart::kYear}) {
      if (is_named(layout.columns[i], part)) return i;
    }
  }
  return std::nullopt;
}

std::optional<std::string> time_of_parts(std::span<const double> parts) {
  const bool dated = parts_have_date(parts.size());
  const std::size_t place = dated ? 0 : kDateParts - kClockParts;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t at = place + i;
    const bool elapsed = !dated && i == 0;
    const bool last = i + 1 == parts.size();
    if (!(parts[i] >= kLeast[at]) || !(elapsed || parts[i] < kMost[at] + 1) ||
        !(last || is_whole(parts[i])) || parts[i] > 99999) {
      return std::nullopt;
    }
  }
  const std::span<const double> clock = parts.subspan(dated ? kClockParts : 0);
  const double minute = std::floor(clock[1]);
  const double second =
      parts_have_second(parts.size()) ? clock[2] : 60 * (clock[1] - minute);
  std::array<char, 80> text{};
  // The last digit of a number of seconds may not make it 60.
  std::snprintf(text.data(), text.size(), "%02.0f:%02.0f:%010.7f", clock[0], minute,
                std::min(second, 59.9999999));
  if (!dated) return text.data();
  constexpr double kCentury = 100;
  double year = parts[0];
  if (year < kCentury) year += year < 70 ? 2000 : 1900;
  if (year < kFirstYear) return std::nullopt;
  std::array<char, 80> date{};
  std::snprintf(date.data(), date.size(), "%04.0f-%02.0f-%02.0f ", year, parts[1],
                parts[2]);
  return std::string(date.data()) + text.data();
}

}  // namespace workbench
