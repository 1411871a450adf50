// The process behind a valve at the rate of the recording, from a search at a lower one.
#pragma once

#include <cstddef>
#include <span>

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
  [[nodiscard]] Real fit_percent(std::size_t samples) const;
};

/// Begins to solve gain, dead time, offset and start again on every sample of stem and y,
/// the poles taken from a model that was searched at means of `decimation` samples. A
/// constant load makes an integrating process drift, so only that may. What is returned
/// lacks its fit, which is the result of `regression` when that is done.
template <class Real>
[[nodiscard]] FullRateProcess<Real> begin_full_rate_process(
    const ValveModel<Real>& model, int decimation, std::span<const Real> stem,
    std::span<const Real> y, ProcessRegression<Real>& regression);

}  // namespace ident
