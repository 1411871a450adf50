// How every figure is taken: the least processor time of several repetitions, which other
// work on the machine disturbs least.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace bench {

inline constexpr int kRepetitions = 5;

template <class Real>
[[nodiscard]] constexpr const char* precision() {
  return std::is_same_v<Real, float> ? "f32" : "f64";
}

/// Registers `body` under `name`. `min_time_s`: of each repetition; 0: one run each.
template <class Body>
void measure(const std::string& name, double min_time_s, Body body) {
  auto* registered = benchmark::RegisterBenchmark(name.c_str(), std::move(body));
  registered->Unit(benchmark::kMicrosecond)
      ->Repetitions(kRepetitions)
      ->ReportAggregatesOnly()
      ->ComputeStatistics("min", [](const std::vector<double>& times) {
        return *std::min_element(times.begin(), times.end());
      });
  if (min_time_s > 0) {
    registered->MinTime(min_time_s);
  } else {
    registered->Iterations(1);
  }
}

void register_pushes();
void register_identification();
void register_scaling();

}  // namespace bench
