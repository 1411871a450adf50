// The two-path model worked sample by sample, straight from its equations.
#pragma once

#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>

#include "ident/two_path/two_path_model.hpp"

namespace test {

/// Free simulation from x alone, equation (8). `initial` holds the additions to the first
/// samples that stand for what the process remembered; x and y have equal length, and
/// before the first sample x kept its first value.
template <class Real>
void free_run(const ident::Process<Real>& process, std::span<const Real> x,
              std::span<const Real> initial, std::span<Real> y) {
  for (std::ptrdiff_t t = 0; t < static_cast<std::ptrdiff_t>(x.size()); ++t) {
    y[t] = process.d;
    for (int j = 0; j < process.nb; ++j) {
      const std::ptrdiff_t s = t - process.nk - 1 - j;
      y[t] += process.b[j] * x[s > 0 ? s : 0];
    }
    for (int i = 0; i < process.na && i < t; ++i) {
      y[t] -= process.a[i] * y[t - 1 - i];
    }
    y[t] += t < static_cast<std::ptrdiff_t>(initial.size()) ? initial[t] : Real(0);
  }
}

/// The valve position x(t) = f(u(t)), equation (2), by the direction of each sample.
template <class Real>
void valve_positions(const ident::TwoPathModel<Real>& model, std::span<const Real> u,
                     std::span<const unsigned char> ascending, std::span<Real> x) {
  for (std::size_t t = 0; t < u.size(); ++t) {
    x[t] = ascending[t] ? model.ascending.at(u[t]) : model.descending.at(u[t]);
  }
}

/// Fit of equation (23) in percent; y is not constant.
template <class Real>
Real fit_percent(std::span<const Real> simulated, std::span<const Real> y) {
  const Real mean =
      std::accumulate(y.begin(), y.end(), Real(0)) / static_cast<Real>(y.size());
  Real error = 0;
  Real spread = 0;
  for (std::size_t t = 0; t < y.size(); ++t) {
    error += (simulated[t] - y[t]) * (simulated[t] - y[t]);
    spread += (y[t] - mean) * (y[t] - mean);
  }
  return Real(100) * (Real(1) - std::sqrt(error / spread));
}

}  // namespace test
