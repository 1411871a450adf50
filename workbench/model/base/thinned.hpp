// A long recording in fewer samples, for searches that simulate it thousands of times.
#pragma once

#include <cstddef>

#include "workbench/recording/recording.hpp"

namespace workbench {

/// Samples that become one: so many that a long recording comes down to some 5,000, as
/// far as the output still has a few samples for what it remembers (`memory_samples`, as
/// in fit.hpp). 1 for a recording that is short enough.
[[nodiscard]] std::size_t thinning_of(std::size_t samples, double memory_samples);

/// Of each `count` ≥ 1 samples the mean of u and of each load, which act over all of
/// them, and the first of everything else. What is left over at the end, of each piece
/// too, is dropped.
[[nodiscard]] Recording thinned(const Recording& recording, std::size_t count);

}  // namespace workbench
