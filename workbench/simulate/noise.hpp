// Noise and load signals.
#pragma once

#include <cstddef>
#include <vector>

#include "workbench/simulate/random.hpp"

namespace workbench {

/// First-order noise v(t) = pole · v(t-1) + e(t), e white with the given standard
/// deviation, |pole| < 1; starts in its stationary state.
[[nodiscard]] std::vector<double> first_order_noise(Random& random, std::size_t samples,
                                                    double pole, double innovation_std);

/// The same with the standard deviation of v itself given.
[[nodiscard]] std::vector<double> coloured_noise(Random& random, std::size_t samples,
                                                 double pole, double std);

}  // namespace workbench
