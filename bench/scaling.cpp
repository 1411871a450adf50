// How the cost grows with the length of the window, the knots and the orders.
#include <memory>

#include "bench/measure.hpp"
#include "bench/parts.hpp"

namespace bench {
namespace {

constexpr double kMinTime_s = 0.02;

void measure_structure(const std::string& axis, int size,
                       const std::shared_ptr<const ScaledWindow<double>>& window,
                       const ident::Structure& structure) {
  const std::string end = "/" + std::to_string(size);
  measure(axis + "/iteration" + end, kMinTime_s,
          [window, structure](benchmark::State& state) {
            const auto gram = std::make_unique<ident::LaggedGram<double>>();
            const auto iteration = std::make_unique<ident::TwoPathIteration<double>>();
            ident::TwoPathModel<double> model;
            sum_up(window->view(), *gram);
            for ([[maybe_unused]] auto _ : state) {
              iteration->start(*gram, structure, model);
              while (!iteration->step()) {
              }
              benchmark::DoNotOptimize(model);
            }
          });
  measure(axis + "/refinement" + end, kMinTime_s,
          [window, structure](benchmark::State& state) {
            RefinementPart<double> part(*window, structure);
            for ([[maybe_unused]] auto _ : state) {
              benchmark::DoNotOptimize(part.run());
            }
          });
}

}  // namespace

void register_scaling() {
  const auto window =
      std::make_shared<const ScaledWindow<double>>(example_window<double>());
  for (const int samples : {700, 1000, 1400, 2000, 2800}) {
    const auto part = std::make_shared<const ScaledWindow<double>>(
        example_window<double>(static_cast<std::size_t>(samples)));
    const std::string end = "/" + std::to_string(samples);
    measure("length/sums" + end, kMinTime_s, [part](benchmark::State& state) {
      const auto gram = std::make_unique<ident::LaggedGram<double>>();
      for ([[maybe_unused]] auto _ : state) {
        sum_up(part->view(), *gram);
        benchmark::DoNotOptimize(*gram);
      }
    });
    measure_structure("length", samples, part, {2, 2, 4, 6, 6});
    measure("length/search" + end, 0, [part](benchmark::State& state) {
      SearchPart<double> search(*part,
                                ident::StructureSearch<double>::ValveKind::kTwoPath);
      for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(search.run());
      }
    });
    measure("length/run" + end, 0, [samples](benchmark::State& state) {
      const auto u = example_u<double>(static_cast<std::size_t>(samples));
      const auto y = example_y<double>(static_cast<std::size_t>(samples));
      const auto identifier = std::make_unique<WholeIdentifier<double>>();
      for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(identifier->run(u, y, {}));
      }
    });
  }
  for (const int segments : {1, 2, 3, 4, 6, 12}) {
    measure_structure("knots", segments, window, {2, 2, 4, segments, segments});
  }
  for (const int order : {1, 2, 3, 4}) {
    measure_structure("orders", order, window, {order, order, 4, 6, 6});
  }
}

}  // namespace bench
