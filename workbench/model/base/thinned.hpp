// A long recording in fewer samples, for searches that simulate it thousands of times.
#pragma once

#include <cstddef>

#include "workbench/recording/recording.hpp"

namespace workbench {

/// Samples that become one: so many that a long recording comes down to some 5,000, but
/// no more than leaves u and `output` at rest within them, up to a hundredth of their
/// variance: a lag, a dead time or a stem that is over within one sample cannot be told,
/// (W16).
/// 1 for a recording that is short enough, or moves fast.
[[nodiscard]] std::size_t thinning_of(const Recording& recording, Column output);

/// Of each `count` ≥ 1 samples the mean of u and of each load, which act over all of
/// them, and the first of everything else. What is left over at the end, of each piece
/// too, is dropped.
[[nodiscard]] Recording thinned(const Recording& recording, std::size_t count);

}  // namespace workbench
