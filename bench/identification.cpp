// The identification of 2,800 samples, whole and in parts, in both precisions.
#include <memory>

#include "bench/measure.hpp"
#include "bench/parts.hpp"

namespace bench {
namespace {

constexpr double kMinTime_s = 0.05;
constexpr ident::Structure kUsual{2, 2, 4, 6, 6};

template <class Real>
void register_for() {
  const std::string suffix = std::string("/") + precision<Real>();
  const auto window = std::make_shared<const ScaledWindow<Real>>(example_window<Real>());
  measure("part/sums" + suffix, kMinTime_s, [window](benchmark::State& state) {
    const auto gram = std::make_unique<ident::LaggedGram<Real>>();
    for ([[maybe_unused]] auto _ : state) {
      sum_up(window->view(), *gram);
      benchmark::DoNotOptimize(*gram);
    }
  });
  measure("part/structure" + suffix, kMinTime_s, [window](benchmark::State& state) {
    const auto evaluator = std::make_unique<StructureEvaluator<Real>>();
    evaluator->start(*window);
    for ([[maybe_unused]] auto _ : state) {
      benchmark::DoNotOptimize(evaluator->evaluate(kUsual));
    }
  });
  measure("part/refinement" + suffix, kMinTime_s, [window](benchmark::State& state) {
    RefinementPart<Real> part(*window, kUsual);
    for ([[maybe_unused]] auto _ : state) {
      benchmark::DoNotOptimize(part.run());
    }
  });
  using Kind = typename ident::StructureSearch<Real>::ValveKind;
  for (const Kind kind : {Kind::kTwoPath, Kind::kLinear}) {
    const char* name = kind == Kind::kTwoPath ? "identify/two_path" : "identify/linear";
    measure(name + suffix, 0, [window, kind](benchmark::State& state) {
      SearchPart<Real> part(*window, kind);
      for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(part.run());
      }
    });
  }
  measure("identify/valve" + suffix, 0, [window](benchmark::State& state) {
    ValvePart<Real> part(*window);
    for ([[maybe_unused]] auto _ : state) {
      part.run();
    }
  });
  measure("identify/run" + suffix, 0, [](benchmark::State& state) {
    const std::vector<Real> u = example_u<Real>();
    const std::vector<Real> y = example_y<Real>();
    const auto identifier = std::make_unique<WholeIdentifier<Real>>();
    for ([[maybe_unused]] auto _ : state) {
      benchmark::DoNotOptimize(identifier->run(u, y, {}));
    }
  });
}

}  // namespace

void register_identification() {
  register_for<double>();
  register_for<float>();
  // The list of structures that the Octave peer is given.
  measure("peer/list/f64", kMinTime_s, [](benchmark::State& state) {
    const std::vector<double> u = example_u<double>();
    const std::vector<double> y = example_y<double>();
    const auto list = coordinate_sweep(example_window<double>());
    const auto evaluator = std::make_unique<StructureEvaluator<double>>();
    for ([[maybe_unused]] auto _ : state) {
      const ScaledWindow<double> window = scaled_window<double>(u, y);
      evaluator->start(window);
      for (const StructureFit<double>& entry : list) {
        benchmark::DoNotOptimize(evaluator->evaluate(entry.structure));
      }
    }
  });
}

}  // namespace bench
