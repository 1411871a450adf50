// Times in seconds, what clock they are of, and how they come to run forward.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "workbench/recording/written_zone.hpp"

namespace workbench {

/// Times of all rows, in the order of the file.
struct TimesOfRows {
  std::vector<double> t;      ///< s; from 0 at the first row where dates are written
  bool dated = false;         ///< the clock time of t is known, with its day
  bool time_of_day = false;   ///< that without its day: from midnight of day 0
  bool zoned = false;         ///< dated: with its zone; else local, with summer time
  std::int16_t zone_min = 0;  ///< zoned: minutes east of UTC
  const OpenZone* open_zone = nullptr;  ///< zoned: of letters that several zones share
  /// Of the first row, where it has one.
  [[nodiscard]] KnownZone zone() const { return {zone_min, open_zone}; }
  std::string
      zone_word;  ///< dated, not zoned: letters behind the times that nobody knows
  std::int32_t origin_day =
      0;  ///< dated: day of t = 0, from 1 January 1970; in UTC or local
  double origin_seconds = 0;  ///< time of that day at t = 0, s
  double bare_step_s = 0;     ///< median step of numbers without a unit; 0: none
  /// What the numbers leave open, and how the user says it; nothing: they are clear.
  struct Doubt {
    std::string expected;
    std::string found;
    std::string advice;
  };
  std::optional<Doubt> doubt;
  std::vector<std::string> notes;
};

/// What is `found`: seconds as well as days.
[[nodiscard]] TimesOfRows::Doubt doubt_of_days(const std::string& found);

/// What is `found`: min:s as well as h:min.
[[nodiscard]] TimesOfRows::Doubt doubt_of_clock(const std::string& found);

/// What is to be said of times of zones, in words, that may be hours apart.
[[nodiscard]] TimesOfRows::Doubt doubt_of_zones(const std::string& a,
                                                const std::string& b);

/// The clock time of `t`, as in 2026-05-03T14:30:00.250+02:00; "" where it is not known.
[[nodiscard]] std::string clock_text(const TimesOfRows& times, double t);

/// The zone as the file writes it: CST, IST, or as an offset +02:00; "" no zone, no date.
[[nodiscard]] std::string zone_written(const TimesOfRows& times);

/// Day from 1 January 1970 and time of that day of `t`, local where `times` is.
struct ClockTime {
  std::int32_t day;
  double seconds;
};
[[nodiscard]] ClockTime clock_time(const TimesOfRows& times, double t);

/// 3 May 2026, of a day from 1 January 1970.
[[nodiscard]] std::string date_text(std::int32_t day);

struct TimeOrder {
  bool turned = false;  ///< newest first: times.t is reversed now, the rows must follow
  std::optional<std::size_t> step_back;  ///< first row (as turned) before the row before
  std::vector<std::string> notes;
};

/// Turns times that never rise (at least three rows), and takes off the jumps of daylight
/// saving: in local time, before 4 o'clock or at midnight and across a full hour, where
/// the clock steps back by an hour less one interval, or, on a Sunday, ahead by an hour
/// and one interval. O(n).
[[nodiscard]] TimeOrder put_in_order(TimesOfRows& times);

}  // namespace workbench
