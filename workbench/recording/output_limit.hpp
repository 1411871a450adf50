// A controller output that rests at its own limit.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace workbench {

struct OutputLimit {
  double level = 0;       ///< units of u
  bool upper = false;     ///< else a lower one
  std::size_t stays = 0;  ///< of three samples or more
  double share = 0;       ///< of all samples, in these stays
};

/// The limits that a controller drives `u` into: an end of its range in which it rests at
/// least three times and a twentieth of all samples, while it moves from sample to sample
/// elsewhere. None of an output that is stepped by hand, switched, or coarsely rounded,
/// which rests anywhere. O(samples).
[[nodiscard]] std::vector<OutputLimit> limits_of_output(std::span<const double> u);

}  // namespace workbench
