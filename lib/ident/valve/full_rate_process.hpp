// The process behind a valve at the rate of the recording, from a search at a lower one.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "ident/base/elementary.hpp"
#include "ident/process/process_regression.hpp"
#include "ident/valve/valve_model.hpp"

namespace ident {

/// The process at the rate of the recording. Its output at sample t is that of the fit
/// for the valve's position up to t − delay.
template <class Real>
struct FullRateProcess {
  ProcessPoles<Real> poles;
  ProcessFit<Real> fit;
  std::size_t delay = 0;  ///< samples, on top of the fit's own

  /// Fit of `y` over the samples that the fit covers, equation (23), in %. `y` has unit
  /// variance and `samples` samples.
  [[nodiscard]] Real fit_percent(std::size_t samples) const {
    return Real(100) *
           (Real(1) - std::sqrt(fit.error / static_cast<Real>(samples - delay)));
  }
};

/// Begins to solve gain, dead time, offset and start again on every sample of stem and y,
/// the poles taken from a model that was searched at means of `decimation` samples. A
/// constant load makes an integrating process drift, so only that may. What is returned
/// lacks its fit, which is the result of `regression` when that is done.
template <class Real>
[[nodiscard]] FullRateProcess<Real> begin_full_rate_process(
    const ValveModel<Real>& model, int decimation, std::span<const Real> stem,
    std::span<const Real> y, ProcessRegression<Real>& regression) {
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

}  // namespace ident
