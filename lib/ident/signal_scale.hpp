// Offset and scale that make signals comparable before anything is fitted, docs (M2).
#pragma once

#include <span>

namespace ident {

/// scaled = (value − offset) / factor.
template <class Real>
struct SignalScale {
  bool moves = false;  ///< false: constant, to the precision of its own numbers
  Real offset = 0;     ///< unit of the signal
  Real factor = 1;     ///< unit of the signal

  void apply(std::span<Real> values) const {
    for (Real& value : values) {
      value = (value - offset) / factor;
    }
  }
  /// From a scaled value back to the signal's unit.
  [[nodiscard]] Real back(Real value) const { return value * factor + offset; }
};

/// To 0 … 1. At least one value. One pass.
template <class Real>
[[nodiscard]] SignalScale<Real> scale_of_range(std::span<const Real> values);

/// To zero mean and unit variance. At least one value. Two passes.
template <class Real>
[[nodiscard]] SignalScale<Real> scale_of_variance(std::span<const Real> values);

/// Means of `count` values each, scaled to zero mean and unit variance; `means` tells how
/// many. False, and the means unscaled, if they are all alike. One pass.
template <class Real>
[[nodiscard]] bool scaled_means(std::span<const Real> values, int count,
                                std::span<Real> means);

}  // namespace ident
