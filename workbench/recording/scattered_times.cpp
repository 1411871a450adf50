#include "workbench/recording/scattered_times.hpp"

#include <algorithm>
#include <cstddef>

namespace workbench {

std::optional<ScatteredTimes> scattered_times(std::span<const double> t) {
  constexpr std::size_t kFewest = 10;
  if (t.size() < kFewest) return std::nullopt;
  const double middle = (static_cast<double>(t.size()) - 1) / 2;
  double sum = 0;
  double products = 0;
  double squares = 0;
  for (std::size_t k = 0; k < t.size(); ++k) {
    const double at = static_cast<double>(k) - middle;
    sum += t[k] - t[0];
    products += at * (t[k] - t[0]);
    squares += at * at;
  }
  const double period = products / squares;
  const double mean = sum / static_cast<double>(t.size());
  double early = 0;
  double late = 0;
  for (std::size_t k = 0; k < t.size(); ++k) {
    const double off = t[k] - t[0] - mean - period * (static_cast<double>(k) - middle);
    early = std::min(early, off);
    late = std::max(late, off);
  }
  const double most = std::max(-early, late);
  if (!(2 * most < period)) return std::nullopt;
  return ScatteredTimes{period, most};
}

}  // namespace workbench
