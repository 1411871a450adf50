// Numbers that count minutes, hours or days and were rounded to a few decimals.
#pragma once

#include <optional>
#include <vector>

#include "workbench/recording/times_of_rows.hpp"

namespace workbench {

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
