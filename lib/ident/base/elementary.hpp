// Elementary functions that give the same bits on every target.
//
// The C libraries of a gateway and of a bare board differ in the last bit of exp, log and
// the like; a search that compares thousands of errors can end elsewhere for it. These
// are made of IEEE operations alone, so that a recording replayed on a desk does exactly
// what the device did. std::sqrt, std::floor and the other correctly rounded ones need
// no replacement.
#pragma once

#include <cmath>
#include <span>

namespace ident::elementary {

/// Relative error below 3·10⁻⁷; 0 below −87, where float has no full precision left.
/// Cost: 30 instructions of a Cortex-M4F.
[[nodiscard]] float exp(float x);
/// Natural logarithm. Relative error below 3·10⁻⁷; −∞ of 0, NaN of negative numbers.
[[nodiscard]] float log(float x);
/// base > 0, or 0 and exponent > 0. Relative error below 3·10⁻⁷ · (1 + |log of the
/// result|).
[[nodiscard]] float pow(float base, float exponent);
/// |x| ≤ 1000; error below 3·10⁻⁷, of the tangent relative to 1 + tan² x.
[[nodiscard]] float sin(float x);
[[nodiscard]] float cos(float x);
[[nodiscard]] float tan(float x);
/// Angle of (x, y), −π … π, 0 at the origin; error below 5·10⁻⁷.
[[nodiscard]] float atan2(float y, float x);
/// √(x² + y²), whose squares must be numbers.
[[nodiscard]] float hypot(float x, float y);

/// e^x of each x ≤ 0, and 0 below −16. `out` is as long as `x`. Cost: 40 instructions of
/// a Cortex-M4F each; a processor with vectors takes several at a time.
void exp_of_negative(std::span<const float> x, std::span<float> out);
void exp_of_negative(std::span<const double> x, std::span<double> out);

// In double a last bit decides nothing that anybody looks at.
[[nodiscard]] inline double exp(double x) {
  return std::exp(x);
}
[[nodiscard]] inline double log(double x) {
  return std::log(x);
}
[[nodiscard]] inline double pow(double base, double exponent) {
  return std::pow(base, exponent);
}
[[nodiscard]] inline double sin(double x) {
  return std::sin(x);
}
[[nodiscard]] inline double cos(double x) {
  return std::cos(x);
}
[[nodiscard]] inline double tan(double x) {
  return std::tan(x);
}
[[nodiscard]] inline double atan2(double y, double x) {
  return std::atan2(y, x);
}
[[nodiscard]] inline double hypot(double x, double y) {
  return std::hypot(x, y);
}

}  // namespace ident::elementary
