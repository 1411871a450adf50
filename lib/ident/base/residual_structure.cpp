#include "ident/base/residual_structure.hpp"

#include <algorithm>
#include <cmath>

namespace ident {

template <class Real>
void ResidualStructure<Real>::add(Real e) {
  square_ += e * e;
  fourth_ += e * e * e * e;
  for (std::size_t lag = 1; lag <= kLags; ++lag) {
    products_[lag - 1] += e * ring_[(count_ - lag) % kLags];
  }
  ring_[count_ % kLags] = e;
  ++count_;
}

template <class Real>
Real ResidualStructure<Real>::value() const {
  if (count_ < 2 * kLags || !(square_ > Real(0))) {
    return Real(0);
  }
  const Real samples = static_cast<Real>(count_);
  Real sum = 0;
  const Real kurtosis = samples * fourth_ / (square_ * square_);
  Real largest = std::sqrt(samples / Real(24)) * (kurtosis - Real(3));
  std::size_t summed = 0;
  for (std::size_t lags = 1; lags <= kLags; lags *= 2) {
    while (summed < lags) {
      sum += products_[summed++];
    }
    largest =
        std::max(largest, sum / square_ * std::sqrt(samples / static_cast<Real>(lags)));
  }
  return largest;
}

template class ResidualStructure<float>;
template class ResidualStructure<double>;

}  // namespace ident
