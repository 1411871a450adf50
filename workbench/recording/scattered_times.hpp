// Time stamps that scatter about equal steps.
#pragma once

#include <optional>
#include <span>

namespace workbench {

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
