#include "ident/process_sign.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ident {

template <class Real>
int likelier_sign(std::span<const Real> u, std::span<const Real> y, Real period,
                  ProcessRegression<Real>& regression, std::span<Real> scratch) {
  const std::span<Real> turned = scratch.first(y.size());
  const auto least_error = [&](Real sign) {
    std::transform(y.begin(), y.end(), turned.begin(),
                   [sign](Real value) { return sign * value; });
    Real least = regression.screen(u, turned, {}).error;
    // Time constants as shares of the period.
    for (const Real share : {Real(0.03), Real(0.1), Real(0.3), Real(1), Real(3)}) {
      const ProcessPoles<Real> poles{std::exp(Real(-1) / (share * period)), Real(0)};
      least = std::min(least, regression.screen(u, turned, poles).error);
    }
    return least;
  };
  return least_error(Real(-1)) < least_error(Real(1)) ? -1 : 1;
}

#define STICKBAND_INSTANTIATE(Real)                                                    \
  template int likelier_sign<Real>(std::span<const Real>, std::span<const Real>, Real, \
                                   ProcessRegression<Real>&, std::span<Real>);
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)
#undef STICKBAND_INSTANTIATE

}  // namespace ident
