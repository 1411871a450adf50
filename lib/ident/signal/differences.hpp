// How finely the values of one signal differ, and when three of them lie on a line.
#pragma once

#include <span>

namespace ident {

/// Of a signal of at least 3 values, in its unit.
struct Differences {
  double bend = 0;  ///< mean size of the second difference
  double smallest =
      0;            ///< change between neighbours that differ; the largest number: none
  double same = 0;  ///< values closer than this are equal, but for rounding
  /// A second difference up to this is none: a fiftieth of the mean one, or, where the
  /// values are rounded, up to a tenth. White noise stays below it one time in 60 or 12.
  double straight = 0;
};

/// Cost: two passes.
[[nodiscard]] Differences measure_differences(std::span<const double> values);

}  // namespace ident
