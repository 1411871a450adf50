#include "ident/signal_shape.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ident {
namespace {

// Nearer than this share of the range is the same value.
constexpr double kSame = 1e-5;
// More levels than this are as good as a continuum, and fewer samples for each level than
// this are no proof of a lattice.
constexpr std::size_t kMostLevels = 100;
constexpr std::size_t kFewestEach = 3;
// How far from a whole number of steps two levels may be apart, in steps.
constexpr double kOffLattice = 0.1;
constexpr std::size_t kShortestRest = 2;

}  // namespace

template <class Real>
Real level_step(std::span<Real> values) {
  if (values.empty()) {
    return 0;
  }
  std::sort(values.begin(), values.end());
  const Real same = (values.back() - values.front()) * Real(kSame);
  std::size_t levels = 1;
  Real step = values.back() - values.front();
  for (std::size_t t = 1; t < values.size(); ++t) {
    const Real gap = values[t] - values[t - 1];
    if (gap > same) {
      ++levels;
      step = std::min(step, gap);
    }
  }
  if (levels < 2 || levels > kMostLevels || kFewestEach * levels > values.size()) {
    return 0;
  }
  for (std::size_t t = 1; t < values.size(); ++t) {
    const Real steps = (values[t] - values[t - 1]) / step;
    if (std::abs(steps - std::round(steps)) > Real(kOffLattice)) {
      return 0;
    }
  }
  return step;
}

template <class Real>
Real share_at_limits(std::span<const Real> values) {
  if (values.empty()) {
    return 0;
  }
  const auto extremes = std::minmax_element(values.begin(), values.end());
  const Real low = *extremes.first;
  const Real high = *extremes.second;
  const Real same = (high - low) * Real(kSame);
  const auto limit = [=](Real value) {
    return value >= high - same ? 1 : (value <= low + same ? -1 : 0);
  };
  std::size_t resting = 0;
  std::size_t rest = 0;
  int at = 0;
  for (std::size_t t = 0; t <= values.size(); ++t) {
    const int now = t < values.size() ? limit(values[t]) : 0;
    if (now != at || t == values.size()) {
      resting += at != 0 && rest >= kShortestRest ? rest : 0;
      rest = 0;
      at = now;
    }
    ++rest;
  }
  return static_cast<Real>(resting) / static_cast<Real>(values.size());
}

template <class Real>
Real kurtosis(std::span<const Real> values) {
  const Real count = static_cast<Real>(values.size());
  // From the first value, so that equal ones leave exactly nothing.
  Real mean = 0;
  for (const Real value : values) {
    mean += (value - values[0]) / count;
  }
  Real square = 0;
  Real fourth = 0;
  for (const Real value : values) {
    const Real away = value - values[0] - mean;
    const Real distance = away * away;
    square += distance / count;
    fourth += distance * distance / count;
  }
  return square > Real(0) ? fourth / (square * square) : Real(0);
}

#define STICKBAND_INSTANTIATE(Real)                           \
  template Real level_step<Real>(std::span<Real>);            \
  template Real share_at_limits<Real>(std::span<const Real>); \
  template Real kurtosis<Real>(std::span<const Real>);
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)
#undef STICKBAND_INSTANTIATE

}  // namespace ident
