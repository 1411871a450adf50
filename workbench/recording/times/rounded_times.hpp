// Equally spaced times that were written in coarser steps, or scatter.
#pragma once

#include <optional>
#include <span>
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

/// Steps that time stamps scatter about, each about one of its own.
struct ScatteredTimes {
  double period_s = 0;
  /// Largest distance of a stamp from its step, below half of one.
  double most_off_s = 0;
};

/// The line through the stamps by their number, where no stamp is half a step or more
/// off it: how far a stamp is off then does not add up, as it does where samples come at
/// random. The median interval of such stamps says less than the line, which all of them
/// carry. Nothing where a sample is missing, and for fewer than ten of the strictly
/// increasing times `t`. O(n).
[[nodiscard]] std::optional<ScatteredTimes> scattered_times(std::span<const double> t);

}  // namespace workbench
