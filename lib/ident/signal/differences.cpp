#include "ident/signal/differences.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace ident {

Differences measure_differences(std::span<const double> values) {
  constexpr double kStraight = 0.02;
  constexpr double kRounded = 0.1;
  constexpr double kSteps = 2.02;  // of the resolution, that rounding bends a line
  Differences out;
  double largest = 0;
  for (const double value : values) {
    largest = std::max(largest, std::abs(value));
  }
  out.same = 4 * std::numeric_limits<double>::epsilon() * largest;
  out.smallest = std::numeric_limits<double>::max();
  double before = 0;
  for (std::size_t t = 1; t < values.size(); ++t) {
    const double change = values[t] - values[t - 1];
    if (t > 1) {
      out.bend += std::abs(change - before);
    }
    if (std::abs(change) > out.same) {
      out.smallest = std::min(out.smallest, std::abs(change));
    }
    before = change;
  }
  out.bend /= static_cast<double>(values.size() - 2);
  const double rounding = std::max(kSteps * out.smallest, out.same);
  out.straight = std::max(kStraight * out.bend, std::min(rounding, kRounded * out.bend));
  return out;
}

}  // namespace ident
