// From where to where a parameter of a model may lie.
#pragma once

#include "workbench/model/base/model.hpp"

namespace workbench {

struct ParameterRange {
  double low = 0;
  double high = 0;
};

/// Its physical bounds. Where no physics bounds it, to ±1e100: the square of a simulated
/// output is then finite.
[[nodiscard]] ParameterRange range_of(const Parameter& parameter);

/// Whether it lies within them, or a ten-thousandth beyond: files and pages round both
/// bounds and values. False for NaN.
[[nodiscard]] bool may_be(const Parameter& parameter, double value);

}  // namespace workbench
