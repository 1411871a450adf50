// From time stamps as they were recorded to equally spaced samples.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/recording/recording.hpp"

namespace workbench {

/// Samples as read: `t` strictly increasing and finite, `line` the line each
/// came from, `values` by Column (those of Column::t unused), each as long as t
/// or empty; `loads` likewise, in the order of Recording::loads.
struct TimedRows {
  std::vector<double> t;
  std::vector<std::uint32_t> line;
  std::array<std::vector<double>, kColumns> values;
  std::vector<std::vector<double>> loads;
  std::string_view place = "line";  ///< what `line` counts, for people
  /// Times, each between two rows that are of two recordings: a gap, however long.
  std::vector<double> between{};
};

/// The spacing of time stamps.
struct Spacing {
  double period_s = 0;        ///< median interval, refined
  double on_time_share = 0;   ///< share of intervals within 10 % of a multiple of it
  std::size_t irregular = 0;  ///< intervals more than 1 % off a multiple of it
};

/// Spacing of at least two strictly increasing times. The median interval is
/// replaced by the mean over the intervals that are one to three times as long
/// within 10 %, when those are nine in ten: stamps rounded to 0.333 and 0.334 s
/// then do not drift. O(n).
[[nodiscard]] Spacing spacing_of(std::span<const double> t);

/// Moves `rows` into `out` on a grid of equal steps from the first time stamp on.
/// When every interval is within 10 % of a multiple of the period, each row keeps
/// its own instant and only the instants between are filled by holding; so it does where
/// the stamps scatter about equal steps (rounded_times.hpp); otherwise
/// the value at an instant is that of the last row not later than a tenth of a
/// period after it. What lies between recordings is a gap of the report, and none of its
/// other numbers counts it. Fills t, the values, period_s and the report of `out`;
/// out.loads must have the names of rows.loads already. Throws InputError naming `file`
/// when there are fewer than two rows or when the grid would have more than
/// most_instants().
void resample(TimedRows&& rows, const std::string& file, Recording& out);

/// Of a grid of so many rows: twenty times as many and a thousand, up to kMaxSamples.
[[nodiscard]] double most_instants(std::size_t rows);

/// `value` with at most `digits` significant digits, as printf's %g.
[[nodiscard]] std::string number(double value, int digits = 6);
/// A time with at most `digits` significant digits; of a clock that counts from 1970 in
/// as many as tell it from the next sample.
[[nodiscard]] std::string instant(double t_s, double period_s, int digits = 6);

/// "1 row" or "3 rows".
[[nodiscard]] std::string counted(std::size_t count, const char* one, const char* many);

}  // namespace workbench
