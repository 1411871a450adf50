// Dates written as one number, told from how large it is.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

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

}  // namespace workbench
