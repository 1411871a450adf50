// Equally spaced times that were written in coarser steps.
#pragma once

#include <optional>
#include <vector>

namespace workbench {

struct RoundedTimes {
  double step = 0;      ///< what the stamps were cut or rounded to, s
  double period_s = 0;  ///< the roundest that fits, s
  std::vector<double>
      t;  ///< equally spaced but for gaps, each within a step of its stamp
};

/// Finds the spacing of stamps that never fall. Only where that is plain to see: their
/// intervals are of two lengths, neighbouring multiples of the step (0 and 1 where
/// several rows share a stamp), each in one of twenty at least, longer ones aside, which
/// are gaps; and all stamps between two gaps lie within one step of a straight line.
/// O(n).
[[nodiscard]] std::optional<RoundedTimes> unrounded(const std::vector<double>& stamps);

}  // namespace workbench
