#include "ident/signal/signal_scale.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ident {
namespace {

// A movement below this share of the values themselves is none.
constexpr double kResolution = 1e-6;

template <class Real>
bool stands_out(Real movement, Real size) {
  return std::isfinite(movement) && movement > Real(kResolution) * size;
}

// The least power of two above; 0 of 0.
template <class Real>
Real power_above(Real value) {
  int exponent = 0;
  std::frexp(value, &exponent);
  return value > Real(0) ? std::ldexp(Real(1), exponent) : Real(0);
}

}  // namespace

template <class Real>
bool all_finite(std::span<const Real> values) {
  for (const Real value : values) {
    if (!std::isfinite(value)) {
      return false;
    }
  }
  return true;
}

// With p bits to a number, scaling moves a value by 3·2⁻ᵖ of the range at most, scaling
// back by 2⁻ᵖ⁻¹ of the size. Half a step, 2¹⁻ᵖ of the larger of the size and four ranges,
// is more than both.
template <class Real>
ValueGrid<Real>::ValueGrid(std::span<const Real> values) {
  if (values.empty()) {
    return;
  }
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const Real size = power_above(std::max(std::abs(*low), std::abs(*high)));
  const Real anchor = Real(3) * std::max(size, Real(4) * power_above(*high - *low));
  anchor_ = std::isfinite(anchor) ? anchor : Real(0);
}

template <class Real>
SignalScale<Real> scale_of_range(std::span<const Real> values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  SignalScale<Real> scale;
  scale.offset = *low;
  scale.factor = *high - *low;
  scale.moves = stands_out(scale.factor, std::max(std::abs(*low), std::abs(*high)));
  return scale;
}

template <class Real>
SignalScale<Real> scale_of_variance(std::span<const Real> values) {
  Real mean = 0;
  Real size = 0;
  Real count = 0;
  for (const Real value : values) {
    count += Real(1);
    mean += (value - mean) / count;
    size = std::max(size, std::abs(value));
  }
  // In shares of the size, whose squares neither overflow nor vanish.
  Real variance = 0;
  for (const Real value : values) {
    const Real share = (value - mean) / (size > Real(0) ? size : Real(1));
    variance += share * share / count;
  }
  SignalScale<Real> scale;
  scale.offset = mean;
  scale.factor = size * std::sqrt(variance);
  scale.moves = stands_out(scale.factor, size);
  return scale;
}

template <class Real>
bool scaled_means(std::span<const Real> values, int count, std::span<Real> means) {
  const Real share = Real(1) / static_cast<Real>(means.size());
  std::size_t t = 0;
  Real mean = 0;
  for (Real& out : means) {
    Real sum = 0;
    for (int k = 0; k < count; ++k, ++t) {
      sum += values[t];
    }
    out = sum / static_cast<Real>(count);
    mean += out * share;
  }
  Real variance = 0;
  for (const Real value : means) {
    variance += (value - mean) * (value - mean) * share;
  }
  if (!(variance > Real(0))) {
    return false;
  }
  SignalScale<Real>{true, mean, std::sqrt(variance)}.apply(means);
  return true;
}

#define STICKBAND_INSTANTIATE(Real)                                          \
  template bool all_finite<Real>(std::span<const Real>);                     \
  template class ValueGrid<Real>;                                            \
  template SignalScale<Real> scale_of_range<Real>(std::span<const Real>);    \
  template SignalScale<Real> scale_of_variance<Real>(std::span<const Real>); \
  template bool scaled_means<Real>(std::span<const Real>, int, std::span<Real>);
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)

}  // namespace ident
