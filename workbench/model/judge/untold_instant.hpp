// Whether a recording tells when a sudden change came.
#pragma once

#include "workbench/effects/effect.hpp"
#include "workbench/model/fit/fit.hpp"

namespace workbench {

/// (W24) Width in s of the interval of a sudden instant of `effect`, where that is longer
/// than the process remembers; 0 where it is told, and where the effect has none. What
/// does as much at any of those times is a drift, or moves with u. Cost, where it has
/// one: that of thorough_intervals_of().
[[nodiscard]] double untold_instant_s(const Fitter& fitter, const Fit& fit,
                                      const Effect& effect);

}  // namespace workbench
