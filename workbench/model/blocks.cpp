#include "workbench/model/blocks.hpp"

#include <algorithm>
#include <cmath>

namespace workbench {

Blocks::Blocks(std::size_t samples, double memory_samples) {
  constexpr double kFewestPairs = 6;
  constexpr double kMostPairs = 20;
  constexpr double kMemories = 8;
  constexpr double kEstimationShare = 0.6;
  const auto n = static_cast<double>(samples);
  const double pairs = std::clamp(n / (kMemories * std::max(memory_samples, 1.0)),
                                  kFewestPairs, kMostPairs);
  const double length = n / std::round(pairs);
  mask_.assign(samples, 0);
  double start = 0;
  for (int i = 0; start < n; ++i) {
    // Golden-ratio steps spread the variation evenly.
    const double phase = 0.618034 * (i + 1) - std::floor(0.618034 * (i + 1));
    double end = start + length * (0.8 + 0.4 * phase);
    if (end > n - length / 2) end = n;
    const auto first = static_cast<std::size_t>(start);
    const auto last = static_cast<std::size_t>(end);
    const auto middle =
        static_cast<std::size_t>(start + kEstimationShare * (end - start));
    blocks_.push_back({first, middle, true});
    blocks_.push_back({middle, last, false});
    std::fill(mask_.begin() + first, mask_.begin() + middle, 1);
    estimation_samples_ += middle - first;
    start = end;
  }
}

}  // namespace workbench
