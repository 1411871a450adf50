// Counting the cycles of a simulated signal.
#pragma once

#include <span>

namespace workbench {

struct Cycles {
  double period = 0;  ///< mean length of a whole cycle in samples, 0 if fewer than one
  int count = 0;      ///< whole cycles seen
  double spread = 0;  ///< standard deviation of the cycle lengths over their mean
};

/// Counts upward crossings of the mean that follow an excursion of 0.3 standard
/// deviations below it, so that noise well below the oscillation adds none.
[[nodiscard]] Cycles measure_cycles(std::span<const double> signal);

/// Standard deviation, divisor N.
[[nodiscard]] double std_of(std::span<const double> signal);
/// Largest minus smallest value.
[[nodiscard]] double swing_of(std::span<const double> signal);

}  // namespace workbench
