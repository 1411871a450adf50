// A sweep by hand: the levels at which u was held, and what y came to at each.
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "workbench/effects/situation.hpp"

namespace workbench {

/// Levels one after the other at which u was held, as in a sweep in small steps; 0 where
/// it was not moved by hand.
[[nodiscard]] int levels_held(std::span<const double> u);

/// What y came to at levels of u, on samples that may be fitted. A straight line between
/// them; beyond the last ones as there.
class SettledCurve {
 public:
  /// Nothing where u was held at fewer than six levels or the model so far integrates.
  [[nodiscard]] static std::optional<SettledCurve> seen_in(const Situation& situation);

  [[nodiscard]] double operator()(double u) const;

 private:
  std::vector<std::pair<double, double>> points_;  // u and y, by u
};

}  // namespace workbench
