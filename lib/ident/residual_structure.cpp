#include "ident/residual_structure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace ident {
namespace {

constexpr std::size_t kLags = 16;

}  // namespace

template <class Real>
Real residual_structure(std::span<const Real> y, std::span<const Real> simulated) {
  std::array<Real, kLags> ring{};
  std::array<Real, kLags> products{};
  Real square = 0;
  Real fourth = 0;
  for (std::size_t t = 0; t < y.size(); ++t) {
    const Real e = y[t] - simulated[t];
    square += e * e;
    fourth += e * e * e * e;
    for (std::size_t lag = 1; lag <= kLags; ++lag) {
      products[lag - 1] += e * ring[(t - lag) % kLags];
    }
    ring[t % kLags] = e;
  }
  if (y.size() < 2 * kLags || !(square > Real(0))) {
    return Real(0);
  }
  const Real samples = static_cast<Real>(y.size());
  Real sum = 0;
  const Real kurtosis = samples * fourth / (square * square);
  Real largest = std::sqrt(samples / Real(24)) * (kurtosis - Real(3));
  std::size_t summed = 0;
  for (std::size_t lags = 1; lags <= kLags; lags *= 2) {
    while (summed < lags) {
      sum += products[summed++];
    }
    largest =
        std::max(largest, sum / square * std::sqrt(samples / static_cast<Real>(lags)));
  }
  return largest;
}

#define STICKBAND_INSTANTIATE(Real) \
  template Real residual_structure<Real>(std::span<const Real>, std::span<const Real>);
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)
#undef STICKBAND_INSTANTIATE

}  // namespace ident
