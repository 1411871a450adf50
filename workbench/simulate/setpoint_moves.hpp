// Ways in which a setpoint or a load moves.
#pragma once

#include <cstddef>
#include <vector>

#include "workbench/simulate/random.hpp"

namespace workbench {

/// Levels in [-1, 1] held for `hold` samples on average (half to twice of it).
[[nodiscard]] std::vector<double> step_moves(Random& random, std::size_t samples,
                                             double hold);
/// The same levels reached by ramps.
[[nodiscard]] std::vector<double> ramp_moves(Random& random, std::size_t samples,
                                             double hold);
/// Smooth irregular motion, as an outer controller of a cascade makes it: a few
/// sinusoids of periods from half to three times `period`; |value| <= 1.
[[nodiscard]] std::vector<double> smooth_moves(Random& random, std::size_t samples,
                                               double period);
/// One of the three.
[[nodiscard]] std::vector<double> draw_moves(Random& random, std::size_t samples,
                                             double scale);
/// A sinusoid of amplitude 1 whose momentary period wanders by `irregularity`
/// (standard deviation over mean; 0 = strictly periodic).
[[nodiscard]] std::vector<double> sinusoid(Random& random, std::size_t samples,
                                           double period, double irregularity);

}  // namespace workbench
