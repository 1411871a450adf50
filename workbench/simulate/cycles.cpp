#include "workbench/simulate/cycles.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "workbench/recording/statistics.hpp"

namespace workbench {

double std_of(std::span<const double> signal) {
  const double mean = mean_of(signal);
  double sum = 0;
  for (const double value : signal) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(signal.size()));
}

double swing_of(std::span<const double> signal) {
  const auto [low, high] = std::ranges::minmax_element(signal);
  return *high - *low;
}

Cycles measure_cycles(std::span<const double> signal) {
  Cycles cycles;
  const double mean = mean_of(signal);
  const double margin = 0.3 * std_of(signal);
  if (margin == 0) return cycles;

  std::vector<double> rises;
  bool armed = false;
  for (std::size_t t = 0; t < signal.size(); ++t) {
    if (signal[t] < mean - margin) armed = true;
    if (armed && signal[t] > mean + margin) {
      rises.push_back(static_cast<double>(t));
      armed = false;
    }
  }
  if (rises.size() < 2) return cycles;
  cycles.count = static_cast<int>(rises.size()) - 1;
  cycles.period = (rises.back() - rises.front()) / cycles.count;
  double sum = 0;
  for (std::size_t i = 1; i < rises.size(); ++i) {
    const double off = rises[i] - rises[i - 1] - cycles.period;
    sum += off * off;
  }
  cycles.spread = std::sqrt(sum / cycles.count) / cycles.period;
  return cycles;
}

}  // namespace workbench
