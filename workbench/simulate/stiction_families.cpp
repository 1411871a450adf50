#include <algorithm>
#include <cmath>
#include <utility>

#include "workbench/simulate/cycles.hpp"
#include "workbench/simulate/draft.hpp"
#include "workbench/simulate/families.hpp"
#include "workbench/simulate/setpoint_moves.hpp"

namespace workbench {
namespace {

Friction draw_friction(Random& random, Strokes strokes) {
  const double band = random.log_uniform(1, 12);
  switch (strokes) {
    case Strokes::kEqual:
      return friction_from_s_j(band, band * random.uniform(0.25, 1));
    case Strokes::kOneSided: {
      const Friction up = friction_from_bands(band, 0, 0);
      const Friction down = friction_from_bands(0, band, 0);
      return random.chance(0.5) ? up : down;
    }
    case Strokes::kMixed: {
      const double smaller = band * random.uniform(0.35, 0.8);
      const double deadband = smaller * random.uniform(0, 0.6);
      return random.chance(0.5) ? friction_from_bands(band, smaller, deadband)
                                : friction_from_bands(smaller, band, deadband);
    }
  }
  return {};
}

// Changes of the stem's direction, each after a travel of at least `travel`.
int reversals(const std::vector<double>& x, double travel) {
  int count = 0;
  int direction = 0;
  double extreme = x.front();
  for (const double value : x) {
    if ((direction >= 0 && value > extreme) || (direction <= 0 && value < extreme)) {
      if (direction == 0 && std::abs(value - extreme) >= travel) {
        direction = value > extreme ? 1 : -1;
      }
      if (direction != 0) extreme = value;
    } else if (std::abs(value - extreme) >= travel) {
      direction = -direction;
      extreme = value;
      ++count;
    }
  }
  return count;
}

bool inside(double value, double low, double high) {
  return value >= low && value <= high;
}

double widest_band(const Friction& friction) {
  return std::max(friction.stick_band_ascending(), friction.stick_band_descending());
}

double widest_jump(const Friction& friction) {
  return std::max(friction.slip_jump_ascending(), friction.slip_jump_descending());
}

// A loop with a valve that sticks, its controller and its place off the balance.
Draft draw_sticking(Random& random, LoopType type, Strokes strokes) {
  Draft draft;
  draw_loop(random, type, draft);
  if (strokes == Strokes::kOneSided) {
    // The free stroke settles unless the loop overshoots on it.
    draft.setup.controller.gain *= random.uniform(1, 1.6);
    draft.setup.controller.reset_time_s *= random.log_uniform(0.25, 0.8);
  }
  draft.valve_model = random.chance(0.5) ? "he" : "sliding";
  draft.friction = draw_friction(random, strokes);
  // Off the balance: the stem starts where the setpoint is not reached.
  const double offset =
      random.sign() * random.uniform(0.1, 0.9) * widest_jump(draft.friction);
  LoopSetup& setup = draft.setup;
  if (setup.process.integrating)
    setup.input_bias = offset;
  else
    setup.setpoint = {setup.process.gain * offset};
  setup.warm_up = 2000;
  setup.samples = 4000;
  return draft;
}

// Length and noise of the recording of a loop that cycles, perhaps at a limit of u.
// False where it would be too short or too long.
bool draw_recording(Random& random, const Trajectory& quiet, const Cycles& cycle,
                    double amplitude, Draft& draft) {
  LoopSetup& setup = draft.setup;
  const double wanted_cycles = random.log_uniform(5.5, 38);
  const double length = std::clamp(wanted_cycles * cycle.period, 600.0, 4000.0);
  if (!inside(length / cycle.period, 5.2, 40)) return false;
  setup.samples = static_cast<std::size_t>(length);
  setup.warm_up = static_cast<std::size_t>(4 * cycle.period) + 300;
  draw_noise(random, setup.warm_up + setup.samples, amplitude / random.log_uniform(3, 40),
             draft);
  if (random.chance(0.3)) {
    const auto [low, high] = std::ranges::minmax_element(quiet.u);
    const double cut = random.uniform(0.05, 0.2) * (*high - *low);
    if (random.chance(0.5))
      setup.controller.high = *high - cut;
    else
      setup.controller.low = *low + cut;
  }
  return true;
}

// Whether the valve makes the cycle that is seen.
bool sticks_visibly(const Draft& draft, const Trajectory& run, const Cycles& seen,
                    const Cycles& cycle) {
  const double band = widest_band(draft.friction);
  return seen.count >= 4 && seen.spread <= 0.4 &&
         inside(static_cast<double>(draft.setup.samples) / seen.period, 5, 40) &&
         inside(seen.period / cycle.period, 0.6, 1.6) && swing_of(run.u) >= 1.1 * band &&
         swing_of(run.y_clean) / 2 >= 3 * draft.noise_std &&
         std_of(run_with_linear_valve(draft).u) <= 0.25 * band;
}

// The same loop while the setpoint moves; false where the valve hardly shows then.
bool move_setpoint(Random& random, const Cycles& cycle, double amplitude, Draft& draft,
                   Trajectory& run) {
  LoopSetup& setup = draft.setup;
  const double reach = amplitude * random.log_uniform(0.5, 4);
  const double start = setup.setpoint.empty() ? 0 : setup.setpoint[0];
  setup.setpoint = draw_moves(random, setup.warm_up + setup.samples,
                              cycle.period * random.log_uniform(0.7, 6));
  for (double& value : setup.setpoint) value = start + reach * value;
  run = run_draft(draft);
  return swing_of(run.u) >= 1.1 * widest_band(draft.friction) &&
         reversals(run.x, 0.5 * widest_jump(draft.friction)) >= 8 &&
         std::ranges::count(run.u, 0.0) + std::ranges::count(run.u, 100.0) == 0;
}

}  // namespace

SimulatedLoop stiction_family(std::string_view scenario, std::uint64_t seed,
                              Strokes strokes, bool level, bool moving_setpoint) {
  Random random(scenario, seed);
  // Not drawn again: loops that rarely cycle would vanish from the family.
  const LoopType type = level ? LoopType::kLevel : draw_loop_type(random);
  for (int redraw = 0; redraw < kMostRedraws; ++redraw) {
    Draft draft = draw_sticking(random, type, strokes);
    const Trajectory quiet = run_draft(draft);
    const Cycles cycle = measure_cycles(quiet.y_clean);
    if (cycle.count < 4 || !inside(cycle.period, 15, 800) || cycle.spread > 0.2) continue;
    const double amplitude = swing_of(quiet.y_clean) / 2;
    if (swing_of(run_with_linear_valve(draft).y) > 0.05 * amplitude) continue;
    if (!draw_recording(random, quiet, cycle, amplitude, draft)) continue;
    Trajectory run = run_draft(draft);
    const Cycles seen = measure_cycles(run.y_clean);
    if (!sticks_visibly(draft, run, seen, cycle)) continue;
    if (moving_setpoint && !move_setpoint(random, cycle, amplitude, draft, run)) continue;
    const Units units = draw_units(random, swing_of(run.y));
    SimulatedLoop loop =
        finish(draft, std::move(run), units, scenario, seed, "stiction", "stiction");
    loop.truth.oscillation_period_s = moving_setpoint ? 0 : seen.period * loop.period_s;
    return loop;
  }
  no_loop(scenario, seed);
}

}  // namespace workbench
