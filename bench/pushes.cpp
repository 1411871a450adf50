// What every sample costs: time of one pass of pushes over the example.
#include <cstdint>
#include <memory>

#include "bench/example_window.hpp"
#include "bench/measure.hpp"
#include "ident/base/configurations.hpp"
#include "ident/monitor.hpp"
#include "ident/signal/oscillation_detector.hpp"
#include "ident/signal/sample_window.hpp"

namespace bench {
namespace {

constexpr double kMinTime_s = 0.05;
constexpr std::int64_t kPeriod_us = 500'000;

// Pushes the example again and again, as one recording without end.
template <class Real, class Target>
void push_example(benchmark::State& state, Target& target) {
  const std::vector<Real> u = example_u<Real>();
  const std::vector<Real> y = example_y<Real>();
  ident::Sample<Real> sample;
  for ([[maybe_unused]] auto _ : state) {
    for (std::size_t t = 0; t < u.size(); ++t) {
      sample.t_us += kPeriod_us;
      sample.u = u[t];
      sample.y = y[t];
      benchmark::DoNotOptimize(target.push(sample));
    }
  }
}

template <class Real>
void register_for() {
  const std::string suffix = std::string("/") + precision<Real>();
  measure("push/detector" + suffix, kMinTime_s, [](benchmark::State& state) {
    const std::vector<Real> u = example_u<Real>();
    ident::OscillationDetector<Real> detector;
    for ([[maybe_unused]] auto _ : state) {
      for (const Real value : u) {
        detector.push(value);
      }
    }
    benchmark::DoNotOptimize(detector.report());
  });
  measure("push/window" + suffix, kMinTime_s, [](benchmark::State& state) {
    const auto window =
        std::make_unique<ident::SampleWindow<Real, ident::kStandardWindow>>(kPeriod_us);
    push_example<Real>(state, *window);
  });
  // Evaluations become due and are not carried out: the push alone.
  measure("push/monitor" + suffix, kMinTime_s, [](benchmark::State& state) {
    ident::MonitorSettings<Real> settings;
    settings.sample_period_us = kPeriod_us;
    const auto monitor =
        std::make_unique<ident::Monitor<Real, ident::kStandardWindow>>(settings);
    push_example<Real>(state, *monitor);
  });
}

}  // namespace

void register_pushes() {
  register_for<double>();
  register_for<float>();
}

}  // namespace bench
