#include "ident/identifier.hpp"

#include <algorithm>

#include "ident/base/configurations.hpp"

namespace ident {

template <class Real, std::size_t Capacity>
void Identifier<Real, Capacity>::start(std::span<const Real> u, std::span<const Real> y,
                                       std::span<const Real> sp, int gain_sign,
                                       const WindowOptions& options) {
  const std::size_t count = std::min({u.size(), y.size(), Capacity});
  std::copy_n(u.begin(), count, u_.begin());
  std::copy_n(y.begin(), count, y_.begin());
  InPlaceIdentifier<Real, Capacity>::start({u_.data(), count}, {y_.data(), count}, sp,
                                           gain_sign, options);
}

template <class Real, std::size_t Capacity>
const Identification<Real>& Identifier<Real, Capacity>::run(std::span<const Real> u,
                                                            std::span<const Real> y,
                                                            std::span<const Real> sp,
                                                            int gain_sign) {
  start(u, y, sp, gain_sign);
  while (!this->step(kLargeBudget)) {
  }
  return this->result();
}

template class Identifier<float, kSmallWindow>;
template class Identifier<float, kStandardWindow>;
template class Identifier<float, kLargeWindow>;
template class Identifier<double, kSmallWindow>;
template class Identifier<double, kStandardWindow>;
template class Identifier<double, kLargeWindow>;

}  // namespace ident
