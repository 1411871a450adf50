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

namespace {

// Over the record as a whole; else, where one lasted for a tenth of it, at its largest.
ident::OscillationReport<double> oscillation_of(const std::vector<double>& signal) {
  constexpr std::size_t kOneIn = 10;
  ident::OscillationDetector<double> detector;
  ident::OscillationReport<double> passing;
  std::size_t lasted = 0;
  bool on = false;
  for (const double value : signal) {
    if (detector.push(value)) {
      const ident::OscillationReport<double> now = detector.present();
      on = now.oscillating;
      if (on && now.amplitude > passing.amplitude) passing = now;
    }
    lasted += on ? 1 : 0;
  }
  const ident::OscillationReport<double> whole = detector.report();
  return whole.detected || lasted * kOneIn < signal.size() ? whole : passing;
}

}  // namespace

Heard listen(std::span<const double> signal) {
  constexpr std::size_t kFewestMeans = 256;
  constexpr double kFewestCycles = 8;  // two or three are alike by luck
  constexpr double kHeeded = 0.25;
  const auto size = static_cast<double>(signal.size());
  Heard best;
  std::vector<Heard> all;  // from fast to slow
  for (std::size_t factor = 1; factor == 1 || signal.size() / factor >= kFewestMeans;
       factor *= 16) {
    const auto report = oscillation_of(means(signal, factor));
    const double period = report.period_samples * static_cast<double>(factor);
    if (!report.detected || (factor > 1 && size < kFewestCycles * period)) continue;
    all.push_back({period, report.amplitude, factor});
    if (all.back().amplitude > best.amplitude) best = all.back();
  }
  const auto fastest = std::ranges::find_if(all, [&best](const Heard& heard) {
    return heard.amplitude >= kHeeded * best.amplitude;
  });
  if (fastest != all.end()) best.fastest = fastest->period;
  return best;
}

}  // namespace workbench
