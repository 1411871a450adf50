#include "workbench/simulate/stiction_families.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "workbench/simulate/cycles.hpp"
#include "workbench/simulate/draft.hpp"
#include "workbench/simulate/setpoint_moves.hpp"

namespace workbench {
namespace {

constexpr int kMostRedraws = 5000;

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

}  // namespace

SimulatedLoop stiction_family(std::string_view scenario, std::uint64_t seed,
                              Strokes strokes, bool level, bool moving_setpoint) {
  Random random(scenario, seed);
  // Not drawn again: loops that rarely cycle would vanish from the family.
  const LoopType type = level ? LoopType::kLevel : draw_loop_type(random);
  for (int redraw = 0; redraw < kMostRedraws; ++redraw) {
    Draft draft;
    draw_loop(random, type, draft);
    if (strokes == Strokes::kOneSided) {
      // The free stroke settles unless the loop overshoots on it.
      draft.setup.controller.gain *= random.uniform(1, 1.6);
      draft.setup.controller.reset_time_s *= random.log_uniform(0.25, 0.8);
    }
    draft.valve_model = random.chance(0.5) ? "he" : "sliding";
    draft.friction = draw_friction(random, strokes);
    const double band = std::max(draft.friction.stick_band_ascending(),
                                 draft.friction.stick_band_descending());
    const double jump = std::max(draft.friction.slip_jump_ascending(),
                                 draft.friction.slip_jump_descending());

    // Off the balance: the stem starts where the setpoint is not reached.
    const double offset = random.sign() * random.uniform(0.1, 0.9) * jump;
    LoopSetup& setup = draft.setup;
    if (setup.process.integrating)
      setup.input_bias = offset;
    else
      setup.setpoint = {setup.process.gain * offset};

    setup.warm_up = 2000;
    setup.samples = 4000;
    const Trajectory quiet = run_draft(draft);
    const Cycles cycle = measure_cycles(quiet.y_clean);
    if (cycle.count < 4 || !inside(cycle.period, 15, 800) || cycle.spread > 0.2) continue;
    const double amplitude = swing_of(quiet.y_clean) / 2;
    if (swing_of(run_with_linear_valve(draft).y) > 0.05 * amplitude) continue;

    const double wanted_cycles = random.log_uniform(5.5, 38);
    const double length = std::clamp(wanted_cycles * cycle.period, 600.0, 4000.0);
    if (!inside(length / cycle.period, 5.2, 40)) continue;
    setup.samples = static_cast<std::size_t>(length);
    setup.warm_up = static_cast<std::size_t>(4 * cycle.period) + 300;
    const std::size_t total = setup.warm_up + setup.samples;
    draw_noise(random, total, amplitude / random.log_uniform(3, 40), draft);
    if (random.chance(0.3)) {
      const auto [low, high] = std::minmax_element(quiet.u.begin(), quiet.u.end());
      const double cut = random.uniform(0.05, 0.2) * (*high - *low);
      if (random.chance(0.5))
        setup.controller.high = *high - cut;
      else
        setup.controller.low = *low + cut;
    }

    Trajectory run = run_draft(draft);
    const Cycles seen = measure_cycles(run.y_clean);
    if (seen.count < 4 || seen.spread > 0.4) continue;
    if (!inside(static_cast<double>(setup.samples) / seen.period, 5, 40)) continue;
    if (!inside(seen.period / cycle.period, 0.6, 1.6)) continue;
    if (swing_of(run.u) < 1.1 * band) continue;
    if (swing_of(run.y_clean) / 2 < 3 * draft.noise_std) continue;
    if (std_of(run_with_linear_valve(draft).u) > 0.25 * band) continue;

    if (moving_setpoint) {
      const double reach = amplitude * random.log_uniform(0.5, 4);
      const double start = setup.setpoint.empty() ? 0 : setup.setpoint[0];
      setup.setpoint =
          draw_moves(random, total, cycle.period * random.log_uniform(0.7, 6));
      for (double& value : setup.setpoint) value = start + reach * value;
      run = run_draft(draft);
      if (swing_of(run.u) < 1.1 * band) continue;
      if (reversals(run.x, 0.5 * jump) < 8) continue;
      if (std::ranges::count(run.u, 0.0) + std::ranges::count(run.u, 100.0) > 0) continue;
    }
    const Units units = draw_units(random, swing_of(run.y));
    SimulatedLoop loop =
        finish(draft, std::move(run), units, scenario, seed, "stiction", "stiction");
    loop.truth.oscillation_period_s = moving_setpoint ? 0 : seen.period * loop.period_s;
    return loop;
  }
  throw std::runtime_error("simulate: no loop for scenario " + std::string(scenario) +
                           " and seed " + std::to_string(seed) +
                           "; the family's ranges leave none, try another seed");
}

}  // namespace workbench
