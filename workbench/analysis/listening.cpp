#include "workbench/analysis/listening.hpp"

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
  Heard best;
  for (std::size_t factor = 1; factor == 1 || signal.size() / factor >= kFewestMeans;
       factor *= 16) {
    ident::OscillationDetector<double> detector;
    for (const double value : means(signal, factor)) detector.push(value);
    const auto report = detector.report();
    if (!report.detected || report.amplitude <= best.amplitude) continue;
    best = {report.period_samples * static_cast<double>(factor), report.amplitude,
            factor};
  }
  return best;
}

}  // namespace workbench
