// Numbers that follow from the searched parameters of a fit, such as the stick band from
// deadband and slip jump.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "workbench/effects/effect.hpp"
#include "workbench/model/fit/fit.hpp"

namespace workbench {

struct Interval {
  double low = 0;
  double high = 0;
};

/// What follows from the searched parameters of an effect.
struct DerivedValue {
  const Effect* effect = nullptr;
  const DerivedParameter* parameter = nullptr;
  std::array<std::size_t, 2> slots{};  ///< of Fit::slots, whose values add up
  double value = 0;
  Interval interval;
};

/// Of all effects of a fit, in their order; the intervals are left to the caller.
[[nodiscard]] std::vector<DerivedValue> derived_of(const Fit& fit);

/// `down` and `up` from the value, within what the bounds of its parts leave, and no
/// narrower than the coarsest of their resolutions.
[[nodiscard]] Interval within_bounds(const Fit& fit, const DerivedValue& derived,
                                     double down, double up);

}  // namespace workbench
