#include "workbench/model/fit/lags_in_series.hpp"

#include <utility>

#include "workbench/effects/effects.hpp"
#include "workbench/model/fit/parameter_search.hpp"
#include "workbench/model/fit/start_search.hpp"

namespace workbench {

bool is_lag(const Effect* effect) {
  return effect == &effects::process_second_lag() || effect == &effects::sensor_lag() ||
         effect == &effects::valve_positioner_lag();
}

std::vector<double> slowest_first(FreeRun& run, std::vector<double> p) {
  constexpr int kIterations = 10;
  constexpr double kNats = 2;
  const auto first = first_lag_slot(run);
  if (!first || !FreeRun::is_searched(run.slots(), p, *first)) return p;
  const double worse =
      1 + 2 * kNats / static_cast<double>(run.blocks().estimation_samples());
  for (std::size_t i = 0; i < p.size(); ++i) {
    const FreeRun::Slot& slot = run.slots()[i];
    if (!is_lag(slot.effect) || slot.parameter.initial || !(p[i] > p[*first]) ||
        !FreeRun::is_searched(run.slots(), p, i)) {
      continue;
    }
    const double error = evaluate(run, p).error;
    std::vector<double> swapped = p;
    std::swap(swapped[i], swapped[*first]);
    SearchPoint other =
        descend(run, evaluate(run, std::move(swapped)), kIterations, kNarrowStep);
    if (other.p[i] < other.p[*first] && other.error <= worse * error) {
      p = std::move(other.p);
    }
  }
  return p;
}

}  // namespace workbench
