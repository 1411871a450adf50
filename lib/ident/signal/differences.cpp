#include "ident/signal/differences.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace ident {

template <class Real>
Differences<Real> measure_differences(std::span<const Real> values) {
  constexpr Real kStraight = Real(0.02);
  constexpr Real kRounded = Real(0.1);
  constexpr Real kSteps = Real(2.02);  // of the resolution, that rounding bends a line
  Differences<Real> out;
  Real largest = 0;
  for (const Real value : values) {
    largest = std::max(largest, std::abs(value));
  }
  out.same = Real(4) * std::numeric_limits<Real>::epsilon() * largest;
  out.smallest = std::numeric_limits<Real>::max();
  Real before = 0;
  for (std::size_t t = 1; t < values.size(); ++t) {
    const Real change = values[t] - values[t - 1];
    if (t > 1) {
      out.bend += std::abs(change - before);
    }
    if (std::abs(change) > out.same) {
      out.smallest = std::min(out.smallest, std::abs(change));
    }
    before = change;
  }
  out.bend /= static_cast<Real>(values.size() - 2);
  const Real rounding = std::max(kSteps * out.smallest, out.same);
  out.straight = std::max(kStraight * out.bend, std::min(rounding, kRounded * out.bend));
  return out;
}

template Differences<float> measure_differences<float>(std::span<const float>);
template Differences<double> measure_differences<double>(std::span<const double>);

}  // namespace ident
