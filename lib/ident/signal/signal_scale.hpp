// Offset and scale that make signals comparable before anything is fitted: (M2) of
// docs/model.md.
#pragma once

#include <span>

namespace ident {

/// Whether every value is a number. One pass.
template <class Real>
[[nodiscard]] bool all_finite(std::span<const Real> values);

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
  /// What stands for the signal where there is no model of it.
  [[nodiscard]] Real resting(std::span<const Real> values) const {
    return moves || values.empty() ? offset : values[0];
  }
};

/// Rounds to multiples of a small power of two, so that values bear being scaled and
/// scaled back, as often as liked: `round(scale.back(…))` is the rounded value again, to
/// the bit.
template <class Real>
class ValueGrid {
 public:
  /// Rounds nothing.
  ValueGrid() = default;
  /// For these values, and scales whose offset lies among them. In float a value moves by
  /// less than 2·10⁻⁶ of the largest magnitude, less than 3·10⁻⁷ of it if the range is a
  /// sixteenth. Values near the largest number are not rounded. One pass.
  explicit ValueGrid(std::span<const Real> values);

  [[nodiscard]] Real round(Real value) const { return (value + anchor_) - anchor_; }

 private:
  Real anchor_ = 0;  // beside it numbers are one step apart
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
