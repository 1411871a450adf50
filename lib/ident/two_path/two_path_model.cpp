#include "ident/two_path/two_path_model.hpp"

#include <cmath>
#include <cstddef>

namespace ident {

template <class Real>
bool is_stable(const Process<Real>& process, Real margin) {
  // Roots inside the circle of radius 1 − margin: scale them out to radius 1 first.
  std::array<Real, kMaxNa> c{};
  const Real stretch = Real(1) / (Real(1) - margin);
  Real power = 1;
  for (int i = 0; i < process.na; ++i) {
    power *= stretch;
    c[i] = process.a[i] * power;
  }
  for (int order = process.na; order > 0; --order) {
    const Real k = c[order - 1];
    if (!(std::abs(k) < Real(1))) {
      return false;
    }
    const Real scale = Real(1) / (Real(1) - k * k);
    std::array<Real, kMaxNa> next{};
    for (int i = 0; i + 1 < order; ++i) {
      next[i] = (c[i] - k * c[order - 2 - i]) * scale;
    }
    c = next;
  }
  return true;
}

template <class Real>
void free_run(const Process<Real>& process, std::span<const Real> x,
              std::span<const Real> initial, std::span<Real> y) {
  const int na = process.na;
  const int nb = process.nb;
  const std::ptrdiff_t n = static_cast<std::ptrdiff_t>(x.size());
  for (std::ptrdiff_t t = 0; t < n; ++t) {
    Real sum = process.d;
    for (int j = 0; j < nb; ++j) {
      const std::ptrdiff_t s = t - process.nk - 1 - j;
      sum += process.b[j] * x[s > 0 ? s : 0];
    }
    for (int i = 0; i < na; ++i) {
      if (t - 1 - i >= 0) {
        sum -= process.a[i] * y[t - 1 - i];
      }
    }
    if (t < static_cast<std::ptrdiff_t>(initial.size())) {
      sum += initial[t];
    }
    y[t] = sum;
  }
}

template <class Real>
void valve_positions(const TwoPathModel<Real>& model, std::span<const Real> u,
                     std::span<const unsigned char> ascending, std::span<Real> x) {
  for (std::size_t t = 0; t < u.size(); ++t) {
    x[t] = ascending[t] ? model.ascending.at(u[t]) : model.descending.at(u[t]);
  }
}

template <class Real>
Real fit_percent(std::span<const Real> simulated, std::span<const Real> y) {
  Real mean = 0;
  for (const Real value : y) {
    mean += value;
  }
  mean /= static_cast<Real>(y.size());
  Real error = 0;
  Real spread = 0;
  for (std::size_t t = 0; t < y.size(); ++t) {
    error += (simulated[t] - y[t]) * (simulated[t] - y[t]);
    spread += (y[t] - mean) * (y[t] - mean);
  }
  return spread > Real(0) ? Real(100) * (Real(1) - std::sqrt(error / spread)) : Real(0);
}

#define STICKBAND_INSTANTIATE(Real)                                                     \
  template bool is_stable<Real>(const Process<Real>&, Real);                            \
  template void free_run<Real>(const Process<Real>&, std::span<const Real>,             \
                               std::span<const Real>, std::span<Real>);                 \
  template void valve_positions<Real>(const TwoPathModel<Real>&, std::span<const Real>, \
                                      std::span<const unsigned char>, std::span<Real>); \
  template Real fit_percent<Real>(std::span<const Real>, std::span<const Real>);
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)

}  // namespace ident
