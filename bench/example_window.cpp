#include "bench/example_window.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ident/signal/reversals.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace bench {

const workbench::SimulatedLoop& example() {
  static const workbench::SimulatedLoop loop = [] {
    auto made = workbench::simulate("paper-example-1", kSeed);
    if (!made || made->u.size() < kSamples) {
      throw std::runtime_error("expected scenario paper-example-1 with 2800 samples");
    }
    return *std::move(made);
  }();
  return loop;
}

template <class Real>
std::vector<Real> example_u(std::size_t samples) {
  const auto& u = example().u;
  return {u.begin(), u.begin() + static_cast<std::ptrdiff_t>(samples)};
}

template <class Real>
std::vector<Real> example_y(std::size_t samples) {
  const auto& y = example().y;
  return {y.begin(), y.begin() + static_cast<std::ptrdiff_t>(samples)};
}

template <class Real>
ScaledWindow<Real> scaled_window(std::span<const Real> u, std::span<const Real> y) {
  constexpr Real kReversalShare = Real(0.3);
  ScaledWindow<Real> window{{u.begin(), u.end()}, {y.begin(), y.end()}, {}};
  const auto [low, high] = std::minmax_element(u.begin(), u.end());
  const Real offset = *low;
  const Real range = *high - *low;
  for (Real& value : window.u) {
    value = (value - offset) / range;
  }
  Real mean = 0;
  for (std::size_t t = 0; t < y.size(); ++t) {
    mean += (y[t] - mean) / static_cast<Real>(t + 1);
  }
  Real variance = 0;
  for (const Real value : y) {
    variance += (value - mean) * (value - mean);
  }
  const Real deviation = std::sqrt(variance / static_cast<Real>(y.size()));
  for (Real& value : window.y) {
    value = (value - mean) / deviation;
  }
  window.ascending.resize(u.size());
  ident::mark_directions<Real>(window.u, kReversalShare, window.ascending, {});
  return window;
}

template <class Real>
ScaledWindow<Real> example_window(std::size_t samples) {
  const std::vector<Real> u = example_u<Real>(samples);
  const std::vector<Real> y = example_y<Real>(samples);
  return scaled_window<Real>(u, y);
}

#define STICKBAND_INSTANTIATE(Real)                                       \
  template std::vector<Real> example_u<Real>(std::size_t);                \
  template std::vector<Real> example_y<Real>(std::size_t);                \
  template ScaledWindow<Real> scaled_window<Real>(std::span<const Real>,  \
                                                  std::span<const Real>); \
  template ScaledWindow<Real> example_window<Real>(std::size_t);
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)

}  // namespace bench
