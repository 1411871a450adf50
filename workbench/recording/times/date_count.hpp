// Dates and times written as one number: counts from some day on, told from how large
// they are; digits of a date; minutes, hours and days rounded to a few decimals.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "workbench/recording/times/times_of_rows.hpp"
#include "workbench/recording/written_time.hpp"

namespace workbench {

/// A count of units from some day on.
struct DateCount {
  double unit_s = 1;
  double from_1970 = 0;  ///< the count on 1 January 1970, units
  double ticks = 1;      ///< a second: what is finer is rounding
  bool days = false;     ///< written with few digits, perhaps
  bool zoned = false;    ///< UTC
  std::string_view note =
      {};             ///< what is counted; "": seconds and parts of them from 1970
  bool open = false;  ///< seconds or days: the numbers fit both, and nothing says it
};

/// Median of the steps between values that differ, without sign; 0: none differ.
[[nodiscard]] double median_step(const std::vector<double>& values);

/// The count that all of `values` lie in. From 1970, in s, ms, µs or ns (2000 to 2100);
/// ticks of 100 ns of Windows and .NET (1990 to 2060); days of Excel (20,000 to 80,000,
/// mostly less than half an hour apart) and of MATLAB (1990 to 2060). Days of MATLAB, and
/// of Excel in a column of seconds (`seconds_only`), must be whole seconds apart that no
/// count of 0.1 ms gives; other days of Excel without a unit that a count of 1 ms gives
/// are `open`. `unit_s`: as the header names it; 0: not at all. O(n).
[[nodiscard]] std::optional<DateCount> date_count(const std::vector<double>& values,
                                                  double unit_s, bool seconds_only);

/// Reads 20260514; 260514, which is day, month and year in an open order unless `order`
/// says it; 46156, a day of Excel's (2000 to 2099, perhaps with decimals that are zero).
/// Nothing: none of these. Alone each of them might be any number: ask only where the
/// column is one of dates.
[[nodiscard]] std::optional<WrittenTime> date_digits(
    std::string_view cell, std::optional<DateOrder> order = std::nullopt);

struct RoundedCount {
  double digit_s = 0;     ///< what the last decimal counts, s
  double period_s = 0;    ///< whole seconds; negative where the numbers fall
  std::vector<double> t;  ///< equally spaced from the first number on, s
};

/// The spacing of at least 20 numbers of `unit_s` seconds each, a minute or more, of at
/// most nine decimals, that all lie within one last decimal of a straight line of whole
/// seconds a row, where that decimal is more than a thousandth of the spacing. Nothing:
/// not so, or the numbers are too few to tell which. O(n).
[[nodiscard]] std::optional<RoundedCount> rounded_count(const std::vector<double>& values,
                                                        double unit_s);

/// Puts such times into `out`, with a note. False: they are none.
[[nodiscard]] bool take_rounded_count(const std::vector<double>& values, double unit_s,
                                      TimesOfRows& out);

/// True for such numbers that are days 1, 2, 5, 10, 15, 20, 30 or 60 s apart, and would
/// be less than a thousandth apart as seconds.
[[nodiscard]] bool are_rounded_days(const std::vector<double>& values);

/// True for numbers from 0 to below 1, less than a thousandth apart: parts of a day as
/// well as seconds. Not so where all steps are alike and no half seconds of a day.
[[nodiscard]] bool may_be_parts_of_day(const std::vector<double>& values);

}  // namespace workbench
