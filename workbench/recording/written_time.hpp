// One date or time of day, as people and historians write it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "wire/calendar.hpp"
#include "workbench/recording/written_zone.hpp"

namespace workbench {

enum class DateOrder : std::uint8_t { dmy, mdy, ymd };
inline constexpr std::array kDateOrders = {DateOrder::dmy, DateOrder::mdy,
                                           DateOrder::ymd};
[[nodiscard]] constexpr const char* name_of(DateOrder order) {
  return order == DateOrder::dmy ? "dmy" : order == DateOrder::mdy ? "mdy" : "ymd";
}
/// The one of that name; nothing: there is none.
[[nodiscard]] constexpr std::optional<DateOrder> date_order_named(std::string_view name) {
  for (const DateOrder order : kDateOrders) {
    if (name == name_of(order)) return order;
  }
  return std::nullopt;
}

/// A cell taken apart. The day is known, or its three numbers still wait for the order
/// that the whole column shows.
struct WrittenTime {
  enum class Day : std::uint8_t {
    kNone,          ///< no date in the cell
    kKnown,         ///< `day` counts from 1 January 1970
    kYearLast,      ///< two numbers and a year: day or month first
    kAllTwoDigits,  ///< three numbers of at most two digits: any order
  };
  Day kind = Day::kNone;
  bool has_clock = false;
  bool short_clock = false;  ///< no date, two numbers as 14:30 or, perhaps, min:s
  bool decimal = false;      ///< short_clock: 14:30.5, decimal minutes or decimal seconds
  bool has_zone = false;
  std::int16_t zone_min = 0;  ///< minutes east of UTC, already taken off `seconds`
  const OpenZone* open_zone = nullptr;  ///< of letters that several zones share
  std::string zone_word;                ///< of a zone that is not known: local time
  std::int32_t day = 0;                 ///< kKnown: days since 1 January 1970
  std::uint32_t numbers = 0;            ///< otherwise: packed_date() of the three numbers
  /// Of the day; outside 0 to 86400 after a zone, and where time elapsed. Two numbers
  /// count as hours and minutes here.
  double seconds = 0;

  /// kKnown: of day and clock, since 1 January 1970, s.
  [[nodiscard]] double since_1970_s() const {
    return static_cast<double>(day) * wire::kDayS + seconds;
  }
};

/// Reads
/// - ISO 8601: 2026-05-03T14:30:00.250Z, +02:00, -0400, a blank for T, / or . for -;
///   20260503T143000, 20260503143000, its decimals, 20260503143000250, 202605031430 (not
///   of 2001 to 2012, where yyMMddHHmmss looks alike); the day of the year, 2026-123;
/// - 3.5.2026 14:30:00,250 (dots: day first), 03-May-26 14:30:00, 03. Mai 2026, May 3,
/// 2026
///   2:30:00 PM, Sun May 03 14:30:00 CEST 2026, English and German months, a weekday
///   before;
/// - 5/3/2026 2:30:00 PM, 03-05-2026, 03/05/26: the order stays open unless `order` says;
/// - 14:30, 14:30:00.250, 14:30:00:250 alone; time elapsed: 100:05:00, 4 days 04:05:00.
/// Two-digit years are 1970 to 2069. Zones as in written_zone.hpp. nullopt for anything
/// else, impossible days included. 60 ns.
[[nodiscard]] std::optional<WrittenTime> written_time(
    std::string_view cell, std::optional<DateOrder> order = std::nullopt);

/// Days from 1 January 1970; none where the calendar has no such day.
[[nodiscard]] std::optional<std::int32_t> day_number(int year, int month, int day);

/// The day that three packed numbers mean in an order; nullopt where there is none.
[[nodiscard]] std::optional<std::int32_t> day_of(std::uint32_t numbers,
                                                 WrittenTime::Day kind, DateOrder order);

}  // namespace workbench
