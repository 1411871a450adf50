// Times of day that were written as numbers without marks between their digits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace workbench {

struct ClockDigits {
  std::string form;       ///< "MMSS", "HHMMSS" or "yyMMddHHMMSS"
  std::vector<double> t;  ///< s, from 0
  double first_s = 0;     ///< first time, seconds of its day; of its hour in MMSS
  bool open = false;      ///< MMSS, or HHMM
  std::optional<std::int32_t>
      day;  ///< of the first time, from 1970, where dates are in it
};

/// Takes 80059, 80104 as 8:00:59 and 8:01:04. Only where that is plain to see: minutes
/// and seconds below 60 throughout; three full minutes are passed at least, each time
/// with a jump of 40 or more beyond what the clock goes, after which it goes no farther
/// than within a minute. Numbers that fall pass midnight, or the hour in MMSS.
/// Numbers below 2400 are `open`: they may be HHMM; `to_minutes` reads them so.
[[nodiscard]] std::optional<ClockDigits> clock_digits(const std::vector<double>& numbers,
                                                      bool to_minutes = false);

/// Times of day, s, beside dates.
struct DayTimes {
  std::string form;  ///< "fractions of a day", "HHMMSS" or "HHMM"
  std::vector<double> seconds;
};

/// Takes numbers beside dates as times of day: fractions of a day where all are below 1
/// and apart as is_step_in_days() says; else HHMMSS. Numbers below 2400 are HHMM where
/// `passes_days`, HHMMSS where `most_digits`, the digits of the longest before its
/// decimals, exceeds 4. Nothing: no such times, or HHMM and HHMMSS are both left.
[[nodiscard]] std::optional<DayTimes> times_of_day(const std::vector<double>& numbers,
                                                   std::size_t most_digits,
                                                   bool passes_days);

/// True for a step, as a number, that is 1, 2, 5, 10, 15, 20, 30 or 60 s in days: a
/// spacing of exports, and of no sampled signal in seconds.
[[nodiscard]] bool is_step_in_days(double step);

/// True for a step of whole seconds, five or more, that no recorder is set to, but a
/// clock in milliseconds counts.
[[nodiscard]] bool is_unusual_step(double step);

/// True for whole numbers of which every tenth step or more is not the usual one, none
/// longer than a few: as a loop counts milliseconds that takes one, two or three of them.
/// O(n).
[[nodiscard]] bool is_uneven_count(std::span<const double> times);

}  // namespace workbench
