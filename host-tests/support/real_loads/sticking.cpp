// Loops whose valve sticks.
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "support/real_loads/draft.hpp"
#include "workbench/simulate/cycles.hpp"

namespace workbench::test {
namespace {

constexpr std::size_t kProbe = 2000;  // samples

// Of a sticking loop that is left alone. Where the valve comes to rest, its band stands
// for the movement it would allow.
Movement probe_valve(const Draft& draft, double band) {
  Draft alone = draft;
  alone.setup.warm_up = kProbe / 2;
  alone.setup.samples = kProbe;
  const Trajectory run = run_draft(alone);
  const Cycles cycles = measure_cycles(run.u);
  if (cycles.count < 3 || cycles.spread > 0.5 || !(std_of(run.x) > 0.1 * band)) {
    return {0.4 * band, 0.4 * band / std::abs(draft.setup.controller.gain), 0};
  }
  return {std_of(run.x), std_of(run.y), cycles.period};
}

}  // namespace

std::optional<Movement> draw_sticking_valve(Random& random, const RealLoadPlan& plan,
                                            Draft& draft) {
  draft.valve_model = valve_model(plan.motion);
  draft.friction = draw_friction(random, plan);
  const double band = std::max(draft.friction.stick_band_ascending(),
                               draft.friction.stick_band_descending());
  if (plan.motion == "backlash") {
    const auto factor = ultimate_gain_factor(draft);
    if (!factor) return std::nullopt;
    draft.setup.controller.gain *= *factor * random.uniform(0.5, 0.9);
  }
  // Off the balance: the stem starts where the setpoint is not reached.
  const double offset = random.sign() * random.uniform(0.1, 0.9) * band;
  if (draft.setup.process.integrating) {
    draft.setup.input_bias = offset;
  } else {
    draft.setup.setpoint = {draft.setup.process.gain * offset};
  }
  return probe_valve(draft, band);
}

std::optional<RealLoadLoop> draw_sticking(Random& random, const RealLoadPlan& plan,
                                          const std::vector<RealLoad>& loads) {
  RealLoadDraft loop;
  LoopSetup& setup = loop.draft.setup;
  if (!draw_tuned_loop(random, plan.type, loop.draft)) return std::nullopt;
  const auto alone = draw_sticking_valve(random, plan, loop.draft);
  if (!alone) return std::nullopt;
  const double thinning = static_cast<double>(plan.thinning());
  // The load moves the period, but not by much where the valve makes it.
  if (alone->period > 160 * thinning) return std::nullopt;
  draw_length(random, plan, alone->period, loop.draft);

  const std::vector<double> load = draw_load(random, loads, loop);
  if (load.empty()) return std::nullopt;
  const bool at_output = random.chance(0.5);
  loop.truth.load_at = at_output ? "output" : "input";
  loop.truth.load_share = random.log_uniform(0.1, 6);
  add_load(at_output ? setup.output_load : setup.input_load, load,
           loop.truth.load_share * (at_output ? alone->y : alone->x));
  const double level = setup.setpoint.empty() ? 0 : setup.setpoint[0];
  setup.setpoint = draw_setpoint(random, loop, false);
  const double reach = alone->y * random.log_uniform(1, 8);
  for (double& value : setup.setpoint) value = level + reach * value;
  if (random.chance(0.12)) setup.controller.gap = alone->y * random.uniform(0.1, 0.8);
  add_noise(random, loop, alone->y);
  if (random.chance(0.15)) {
    const double swing = alone->x * random.uniform(2, 4);
    setup.controller.low = std::max(0.0, setup.rest_u - swing);
    setup.controller.high = std::min(100.0, setup.rest_u + swing);
  }
  return record_loop(random, plan, loop);
}

}  // namespace workbench::test
