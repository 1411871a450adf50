#include <algorithm>
#include <span>
#include <utility>

#include "workbench/recording/statistics.hpp"
#include "workbench/simulate/cycles.hpp"
#include "workbench/simulate/draft.hpp"
#include "workbench/simulate/families.hpp"
#include "workbench/simulate/noise.hpp"
#include "workbench/simulate/setpoint_moves.hpp"

namespace workbench {
namespace {

// Root mean square of what the gap adds to y when u is what it was.
double effect_of_gap(const Draft& draft, const Trajectory& run) {
  ProcessModel model = draft.setup.process;
  Process process(model, draft.setup.period_s);
  std::vector<double> effect;
  const double mean = mean_of(run.x) - mean_of(run.u);
  for (std::size_t t = 0; t < run.u.size(); ++t) {
    effect.push_back(process.output());
    process.advance(run.x[t] - run.u[t] - mean);
  }
  return std_of(effect);
}

// A loop that cycles by its play alone; false where this one does not.
bool draw_limit_cycle(Random& random, Draft& draft, double& period, double& amplitude) {
  LoopSetup& setup = draft.setup;
  draw_loop(random, random.chance(0.85) ? LoopType::kLevel : LoopType::kSlow, draft);
  const double gap = random.log_uniform(1, 10);
  draft.friction = friction_from_s_j(gap, 0);
  if (setup.process.integrating)
    setup.input_bias = random.sign() * gap;
  else
    setup.setpoint = {setup.process.gain * gap};
  setup.warm_up = 2000;
  setup.samples = 4000;
  const Trajectory quiet = run_draft(draft);
  const Cycles cycle = measure_cycles(quiet.y_clean);
  if (cycle.count < 4 || cycle.spread > 0.2 || cycle.period < 15 || cycle.period > 720) {
    return false;
  }
  // Dying oscillations are no limit cycle.
  const std::span<const double> y(quiet.y_clean);
  if (swing_of(y.last(1000)) < 0.8 * swing_of(y.first(1000))) return false;
  amplitude = swing_of(quiet.y_clean) / 2;
  if (swing_of(run_with_linear_valve(draft).y) > 0.05 * amplitude) return false;
  period = cycle.period;
  return true;
}

// A loop that settles by itself, to be moved by a load or a setpoint.
bool draw_settling(Random& random, Draft& draft, double& period) {
  draw_loop(random, random.chance(0.6) ? LoopType::kFlow : LoopType::kSlow, draft);
  if (!settles(draft)) return false;
  period = random.log_uniform(20, 200);
  return true;
}

// Moves a loop by a load or its setpoint, and gives it a play to match. Returns the
// amplitude of y behind a valve without play.
double move_loop(Random& random, std::size_t total, double period, Draft& draft) {
  LoopSetup& setup = draft.setup;
  const double swing = random.uniform(5, 30);
  std::vector<double> motion;
  switch (random.integer(0, 2)) {
    case 0:
      motion = sinusoid(random, total, period, 0);
      break;
    case 1:
      motion = coloured_noise(random, total, 1 - 6 / period, 0.5);
      break;
    default:
      motion = draw_moves(random, total, period);
      break;
  }
  const bool load = random.chance(0.5);
  scale(motion, swing / 2 * (load ? 1 : setup.process.gain));
  if (load)
    setup.input_load = motion;
  else
    setup.setpoint = motion;
  const Trajectory linear = run_with_linear_valve(draft);
  const double gap = swing_of(linear.u) * random.uniform(0.15, 0.6);
  draft.friction = friction_from_s_j(gap, 0);
  return swing_of(linear.y) / 2;
}

// Whether the play shows: u crosses it, away from its limits, and y answers.
bool shows(const Draft& draft, const Trajectory& run) {
  const double gap = draft.friction.stick_band_ascending();
  return swing_of(run.u) >= 1.3 * gap && swing_of(run.x) >= 0.15 * swing_of(run.u) &&
         std::ranges::count(run.u, 0.0) + std::ranges::count(run.u, 100.0) == 0 &&
         effect_of_gap(draft, run) >= 1.5 * draft.noise_std;
}

}  // namespace

SimulatedLoop backlash_family(std::string_view scenario, std::uint64_t seed) {
  Random random(scenario, seed);
  const bool limit_cycle = random.chance(0.5);
  for (int redraw = 0; redraw < kMostRedraws; ++redraw) {
    Draft draft;
    LoopSetup& setup = draft.setup;
    draft.valve_model = "backlash";
    double period = 0;
    double amplitude = 0;
    if (limit_cycle ? !draw_limit_cycle(random, draft, period, amplitude)
                    : !draw_settling(random, draft, period)) {
      continue;
    }
    const double wanted_cycles = random.log_uniform(5.5, 38);
    const double length = std::clamp(wanted_cycles * period, 600.0, 4000.0);
    if (length < 5.2 * period || length > 40 * period) continue;
    setup.samples = static_cast<std::size_t>(length);
    setup.warm_up = static_cast<std::size_t>(4 * period) + 300;
    const std::size_t total = setup.warm_up + setup.samples;
    if (!limit_cycle) amplitude = move_loop(random, total, period, draft);
    draw_noise(random, total, amplitude / random.log_uniform(5, 60), draft);

    Trajectory run = run_draft(draft);
    if (!shows(draft, run)) continue;
    const Cycles seen = measure_cycles(run.y_clean);
    if (limit_cycle && (seen.count < 4 || seen.spread > 0.4)) continue;

    const Units units = draw_units(random, swing_of(run.y));
    SimulatedLoop loop =
        finish(draft, std::move(run), units, scenario, seed, "backlash", "backlash");
    if (limit_cycle) loop.truth.oscillation_period_s = seen.period * loop.period_s;
    return loop;
  }
  no_loop(scenario, seed);
}

}  // namespace workbench
