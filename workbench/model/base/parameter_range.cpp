#include "workbench/model/base/parameter_range.hpp"

#include <algorithm>
#include <cmath>

namespace workbench {

ParameterRange range_of(const Parameter& parameter) {
  constexpr double kMost = 1e100;
  return {std::max(parameter.bound_low, -kMost), std::min(parameter.bound_high, kMost)};
}

bool may_be(const Parameter& parameter, double value) {
  constexpr double kRounding = 1e-4;
  const auto [low, high] = range_of(parameter);
  return value >= low - kRounding * std::abs(low) &&
         value <= high + kRounding * std::abs(high);
}

}  // namespace workbench
