#include "workbench/analysis/listening.hpp"

#include <algorithm>

#include "ident/signal/oscillation_detector.hpp"

namespace workbench {

std::vector<double> means(std::span<const double> values, std::size_t count) {
  if (count == 1) return {values.begin(), values.end()};
  std::vector<double> out(values.size() / count);
  for (std::size_t i = 0; i < out.size(); ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < count; ++k) sum += values[i * count + k];
    out[i] = sum / static_cast<double>(count);
  }
  return out;
}

Heard listen(std::span<const double> signal) {
  constexpr std::size_t kFewestMeans = 256;
  constexpr double kHeeded = 0.25;
  Heard best;
  std::vector<Heard> all;  // from fast to slow
  for (std::size_t factor = 1; factor == 1 || signal.size() / factor >= kFewestMeans;
       factor *= 16) {
    ident::OscillationDetector<double> detector;
    for (const double value : means(signal, factor)) detector.push(value);
    const auto report = detector.report();
    if (!report.detected) continue;
    all.push_back(
        {report.period_samples * static_cast<double>(factor), report.amplitude, factor});
    if (all.back().amplitude > best.amplitude) best = all.back();
  }
  const auto fastest = std::ranges::find_if(all, [&best](const Heard& heard) {
    return heard.amplitude >= kHeeded * best.amplitude;
  });
  if (fastest != all.end()) best.fastest = fastest->period;
  return best;
}

}  // namespace workbench
