#include "ident/valve/full_rate_process.hpp"

#include <algorithm>
#include <cmath>

#include "ident/base/elementary.hpp"

namespace ident {

template <class Real>
Real FullRateProcess<Real>::fit_percent(std::size_t samples) const {
  return Real(100) *
         (Real(1) - std::sqrt(fit.error / static_cast<Real>(samples - delay)));
}

template <class Real>
FullRateProcess<Real> begin_full_rate_process(const ValveModel<Real>& model,
                                              int decimation, std::span<const Real> stem,
                                              std::span<const Real> y,
                                              ProcessRegression<Real>& regression) {
  const auto pole_at_full_rate = [&](Real pole) {
    return pole > Real(0) && pole < Real(1)
               ? elementary::pow(pole, Real(1) / static_cast<Real>(decimation))
               : pole;
  };
  FullRateProcess<Real> out;
  out.poles = {pole_at_full_rate(model.poles.slow), pole_at_full_rate(model.poles.fast)};
  // The middle of the dead times that the fit tries.
  out.delay = static_cast<std::size_t>(
      std::max(model.fit.delay * decimation - kDelayTaps / 2, 0));
  const std::size_t used = y.size() - out.delay;
  regression.start_fit(stem.first(used), y.last(used), out.poles, 1, kDelayTaps - 2,
                       !(out.poles.slow < Real(1)));
  return out;
}

#define STICKBAND_INSTANTIATE(Real)                                               \
  template struct FullRateProcess<Real>;                                          \
  template FullRateProcess<Real> begin_full_rate_process<Real>(                   \
      const ValveModel<Real>&, int, std::span<const Real>, std::span<const Real>, \
      ProcessRegression<Real>&);
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)

}  // namespace ident
