#include <cmath>
#include <utility>
#include <vector>

#include "workbench/simulate/cycles.hpp"
#include "workbench/simulate/draft.hpp"
#include "workbench/simulate/families.hpp"
#include "workbench/simulate/noise.hpp"

namespace workbench {
namespace {

// One to four steps after the warm-up, each at least a quarter of the range.
std::vector<double> few_steps(Random& random, std::size_t warm_up, std::size_t samples) {
  std::vector<double> signal(warm_up + samples, 0.0);
  const int steps = random.integer(1, 4);
  double level = 0;
  for (int k = 0; k < steps; ++k) {
    double next = random.uniform(-1, 1);
    while (std::abs(next - level) < 0.5) next = random.uniform(-1, 1);
    level = next;
    const double share = (k + random.uniform(0.1, 0.9)) / steps;
    const auto first =
        warm_up + static_cast<std::size_t>(share * static_cast<double>(samples));
    for (std::size_t t = first; t < signal.size(); ++t) signal[t] = level;
  }
  return signal;
}

}  // namespace

SimulatedLoop few_steps_family(std::string_view scenario, std::uint64_t seed,
                               bool sticks) {
  Random random(scenario, seed);
  for (int redraw = 0; redraw < kMostRedraws; ++redraw) {
    Draft draft;
    LoopSetup& setup = draft.setup;
    draw_loop(random, draw_loop_type(random), draft);
    if (!settles(draft)) continue;
    setup.samples = static_cast<std::size_t>(random.log_uniform(400, 2000));
    setup.warm_up = 1000;
    const std::size_t total = setup.warm_up + setup.samples;

    const double swing = random.log_uniform(3, 40);
    const double pole = 1 - 1 / random.log_uniform(50, 2000);
    setup.input_load = coloured_noise(random, total, pole, 1);
    scale(setup.input_load, swing * random.log_uniform(0.02, 0.3) / free_swing(draft));
    std::vector<double> load = std::exchange(setup.input_load, {});
    setup.setpoint = few_steps(random, setup.warm_up, setup.samples);
    scale(setup.setpoint, swing / free_swing(draft));
    setup.input_load = std::move(load);
    const Trajectory quiet = run_with_linear_valve(draft);
    draw_noise(random, total, swing_of(quiet.y) / 2 / random.log_uniform(5, 100), draft);
    if (sticks) {
      const double band = swing * random.log_uniform(0.08, 0.7);
      draft.valve_model = random.chance(0.5) ? "he" : "sliding";
      draft.friction = friction_from_s_j(band, band * random.uniform(0.25, 1));
    }
    Trajectory run = run_draft(draft);
    SimulatedLoop loop =
        finish(draft, run, draw_units(random, swing_of(run.y)), scenario, seed,
               sticks ? "stiction" : "no_stiction", sticks ? "stiction" : "setpoint");
    if (!loop.truth.u_limited) return loop;
  }
  no_loop(scenario, seed);
}

}  // namespace workbench
