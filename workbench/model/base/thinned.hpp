// A recording with a longer sample period.
#pragma once

#include <cstddef>

#include "workbench/recording/recording.hpp"

namespace workbench {

/// Of each `count` ≥ 1 samples the mean of u and of each load, which act over all of
/// them, and the first of everything else. What is left over at the end, of each piece
/// too, is dropped.
[[nodiscard]] Recording thinned(const Recording& recording, std::size_t count);

}  // namespace workbench
