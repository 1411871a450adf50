#include "ident/verdict/cycle_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "ident/base/elementary.hpp"

namespace ident {

template <class Real>
Real independent_observations(std::span<const Real> y, std::span<const Real> simulated,
                              Real period) {
  Real square = 0;
  Real lagged = 0;
  for (std::size_t t = 0; t < y.size(); ++t) {
    const Real e = y[t] - simulated[t];
    square += e * e;
    if (t > 0) {
      lagged += e * (y[t - 1] - simulated[t - 1]);
    }
  }
  const Real rho =
      square > Real(0) ? std::clamp(lagged / square, Real(0), Real(0.99)) : Real(0);
  const Real turn = elementary::cos(Real(6.2831853) / period);
  const Real share = (Real(1) - Real(2) * rho * turn + rho * rho) / (Real(1) - rho * rho);
  return static_cast<Real>(y.size()) * std::min(share, Real(1));
}

template <class Real>
CycleComparison<Real>::CycleComparison(std::span<const Real> y, Real period)
    : y_(y),
      count_(std::clamp(static_cast<int>(static_cast<Real>(y.size()) / period), kFewest,
                        kMost)) {}

template <class Real>
void CycleComparison<Real>::add(std::span<const Real> simulated, Real weight) {
  const std::size_t n = y_.size();
  for (std::size_t t = 0; t < n; ++t) {
    const Real e = y_[t] - simulated[t];
    gains_[t * static_cast<std::size_t>(count_) / n] += weight * e * e;
  }
}

template <class Real>
CycleGain<Real> CycleComparison<Real>::gain() const {
  CycleGain<Real> out;
  out.cycles = count_;
  const Real count = static_cast<Real>(count_);
  Real mean = 0;
  for (int k = 0; k < count_; ++k) {
    mean += gains_[k] / count;
    out.better += gains_[k] > Real(0) ? 1 : 0;
  }
  Real variance = 0;
  for (int k = 0; k < count_; ++k) {
    variance += (gains_[k] - mean) * (gains_[k] - mean) / (count - Real(1));
  }
  out.consistency = variance > Real(0) ? mean / std::sqrt(variance / count) : Real(0);
  return out;
}

#define STICKBAND_INSTANTIATE(Real)                                          \
  template Real independent_observations<Real>(std::span<const Real>,        \
                                               std::span<const Real>, Real); \
  template class CycleComparison<Real>;
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)

}  // namespace ident
