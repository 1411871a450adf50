// How finely the values of one signal differ, and when three of them lie on a line.
#pragma once

#include <span>

namespace ident {

/// Of a signal of at least 3 values, in its unit.
template <class Real>
struct Differences {
  Real bend = 0;      ///< mean size of the second difference
  Real smallest = 0;  ///< change between neighbours that differ; the largest number: none
  Real same = 0;      ///< values closer than this are equal, but for rounding
  /// A second difference up to this is none: a fiftieth of the mean one, or, where the
  /// values are rounded, up to a tenth. White noise stays below it one time in 60 or 12.
  Real straight = 0;
};

/// Cost: one pass.
template <class Real>
[[nodiscard]] Differences<Real> measure_differences(std::span<const Real> values);

}  // namespace ident
