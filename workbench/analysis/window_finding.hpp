// What one window of a recording says by itself.
#pragma once

#include <cstddef>

#include "ident/verdict/identification.hpp"

namespace workbench {

/// For people.
struct WindowFinding {
  std::size_t recording = 0;  ///< 0 for the first
  double from_s = 0;          ///< time of its first and last sample, s
  double to_s = 0;
  ident::Verdict verdict = ident::Verdict::kUndecided;
  double nats = 0;       ///< closed-loop evidence of its best stick band; NaN: too short
  double stem_nats = 0;  ///< that of its own stem, fitted or searched; NaN: none
  ident::PerStroke<double> stick_band{};  ///< units of u; known where a fault is found
  int gain_sign = 1;                      ///< of the process; where a fault is found
};

}  // namespace workbench
