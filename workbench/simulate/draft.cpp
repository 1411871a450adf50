#include "workbench/simulate/draft.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "workbench/simulate/backlash_valve.hpp"
#include "workbench/simulate/coasting_valve.hpp"
#include "workbench/simulate/cycles.hpp"
#include "workbench/simulate/he_valve.hpp"
#include "workbench/simulate/linear_valve.hpp"
#include "workbench/simulate/noise.hpp"
#include "workbench/simulate/sliding_valve.hpp"

namespace workbench {
namespace {

// Whole samples in half of the draws, any value in the others.
double draw_dead_time(Random& random, double most) {
  const double any = random.uniform(0, most);
  return random.chance(0.5) ? std::round(any) : any;
}

// A process and its tuning, times in samples. Tuning follows the SIMC rules (Skogestad
// 2003), closed-loop time constant `target`, then leaves them by a drawn factor.
struct DrawnLoop {
  ProcessModel process{};
  double period_s = 1;
  double gain = 1;
  double reset = 1;
};

DrawnLoop draw_flow(Random& random) {
  DrawnLoop out;
  out.process.gain = random.log_uniform(0.3, 3);
  out.process.lag_s = random.uniform(0.5, 3);
  if (random.chance(0.25)) out.process.second_lag_s = random.uniform(0.3, 1.5);
  out.process.dead_time_s = draw_dead_time(random, 5);
  const double delay = out.process.dead_time_s + 1 + out.process.second_lag_s / 2;
  const double target = delay * random.log_uniform(1.2, 8);
  out.gain = out.process.lag_s / (target + delay) * random.log_uniform(0.3, 1.5);
  out.reset = out.gain * (target + delay);
  out.period_s = random.log_uniform(0.2, 5);
  return out;
}

DrawnLoop draw_slow(Random& random) {
  DrawnLoop out;
  out.process.gain = random.log_uniform(0.3, 3);
  out.process.lag_s = random.log_uniform(5, 80);
  if (random.chance(0.4)) {
    out.process.second_lag_s = out.process.lag_s * random.uniform(0.1, 0.5);
  }
  out.process.dead_time_s = draw_dead_time(random, 0.6 * out.process.lag_s);
  const double delay = out.process.dead_time_s + 1 + out.process.second_lag_s / 2;
  const double target = delay * random.log_uniform(0.8, 4);
  out.gain = out.process.lag_s / (target + delay);
  out.reset =
      std::min(out.process.lag_s, 4 * (target + delay)) * random.log_uniform(0.4, 1.2);
  out.period_s = random.log_uniform(0.5, 30);
  return out;
}

DrawnLoop draw_level(Random& random) {
  DrawnLoop out;
  out.process.integrating = true;
  out.process.gain = random.log_uniform(0.005, 0.1);
  if (random.chance(0.5)) out.process.lag_s = random.uniform(0.3, 3);
  out.process.dead_time_s = draw_dead_time(random, 4);
  const double delay = out.process.dead_time_s + 1 + out.process.lag_s;
  const double target = delay * random.log_uniform(1.5, 10);
  out.gain = 1 / (target + delay);
  out.reset = 4 * (target + delay) * random.log_uniform(0.35, 1.5);
  out.period_s = random.log_uniform(1, 60);
  return out;
}

void lift_limits(PiSettings& controller) {
  controller.low = PiSettings{}.low;
  controller.high = PiSettings{}.high;
}

// A setpoint step of 1 with a linear valve and no limits.
Trajectory step_freely(const Draft& draft, std::size_t samples, double gain_factor) {
  LoopSetup setup;
  setup.process = draft.setup.process;
  setup.controller = draft.setup.controller;
  lift_limits(setup.controller);
  setup.controller.gain *= gain_factor;
  setup.period_s = draft.setup.period_s;
  setup.positioner_lag_s = draft.setup.positioner_lag_s;
  setup.samples = samples;
  setup.setpoint = {1};
  LinearValve valve;
  return run_loop(setup, valve);
}

}  // namespace

LoopType draw_loop_type(Random& random) {
  const double draw = random.uniform();
  if (draw < 0.5) return LoopType::kFlow;
  return draw < 0.83 ? LoopType::kSlow : LoopType::kLevel;
}

void draw_loop(Random& random, LoopType type, Draft& draft) {
  const DrawnLoop drawn = type == LoopType::kFlow   ? draw_flow(random)
                          : type == LoopType::kSlow ? draw_slow(random)
                                                    : draw_level(random);
  ProcessModel process = drawn.process;
  // Two significant digits, as a technician would set it.
  const double digit = std::pow(10, std::floor(std::log10(drawn.period_s)) - 1);
  const double period = std::round(drawn.period_s / digit) * digit;

  draft.setup.period_s = period;
  draft.setup.controller.gain = drawn.gain / process.gain;
  draft.setup.controller.reset_time_s = drawn.reset * period;
  process.lag_s *= period;
  process.second_lag_s *= period;
  process.dead_time_s *= period;
  if (process.integrating) process.gain /= period;
  if (random.chance(0.35)) {
    process.gain = -process.gain;
    draft.setup.controller.gain = -draft.setup.controller.gain;
  }
  draft.setup.process = process;
  draft.setup.controller.low = 0;
  draft.setup.controller.high = 100;
  draft.setup.rest_u = random.uniform(35, 65);
}

void draw_noise(Random& random, std::size_t samples, double std, Draft& draft) {
  const double pole = random.chance(0.5) ? 0.0 : random.uniform(-0.5, 0.8);
  draft.noise_std = std;
  draft.setup.noise = coloured_noise(random, samples, pole, std);
}

Units draw_units(Random& random, double swing) {
  Units units;
  switch (random.integer(0, 4)) {
    case 0:  // percent
      break;
    case 1:  // fraction
      units.u_scale = 0.01;
      break;
    case 2:  // milliampere
      units.u_scale = 0.16;
      units.u_offset = 4;
      break;
    case 3:  // 12-bit counts
      units.u_scale = 40.95;
      break;
    default:
      units.u_scale = random.log_uniform(0.05, 10);
      units.u_offset = random.uniform(-500, 500);
      break;
  }
  const double wanted = random.log_uniform(0.5, 500);
  units.y_scale = wanted / swing;
  units.y_offset = random.uniform(-2, 10) * wanted;
  return units;
}

std::unique_ptr<Valve> make_valve(const Draft& draft) {
  if (draft.valve_model == "he") return std::make_unique<HeValve>(draft.friction);
  if (draft.valve_model == "sliding")
    return std::make_unique<SlidingValve>(draft.friction);
  if (draft.valve_model == "coasting")
    return std::make_unique<CoastingValve>(draft.friction);
  if (draft.valve_model == "backlash") {
    return std::make_unique<BacklashValve>(draft.friction.stick_band_ascending());
  }
  return std::make_unique<LinearValve>();
}

Trajectory run_draft(const Draft& draft) {
  return run_loop(draft.setup, *make_valve(draft));
}

Trajectory run_with_linear_valve(const Draft& draft) {
  LinearValve valve;
  return run_loop(draft.setup, valve);
}

void scale(std::vector<double>& signal, double factor) {
  for (double& value : signal) value *= factor;
}

double free_swing(Draft draft) {
  lift_limits(draft.setup.controller);
  return swing_of(run_with_linear_valve(draft).u);
}

bool settles(const Draft& draft) {
  const Trajectory step = step_freely(draft, 3000, 1);
  for (std::size_t t = 0; t < step.y.size(); ++t) {
    const double limit = t < 1500 ? 0.7 : 0.02;
    if (!(step.y[t] - 1 < limit)) return false;
    if (t >= 1500 && !(step.y[t] - 1 > -limit)) return false;
  }
  return true;
}

double ringing_growth(const Draft& draft, double gain_factor) {
  const Trajectory run = step_freely(draft, 1500, gain_factor);
  std::vector<double> error;
  for (const double y : run.y) error.push_back(y - 1);
  const std::span<const double> all(error);
  const double early = swing_of(all.subspan(300, 600));
  const double late = swing_of(all.subspan(900, 600));
  if (!std::isfinite(late) || !std::isfinite(early)) return 2;
  return early < 1e-12 ? 0 : late / early;
}

void no_loop(std::string_view scenario, std::uint64_t seed) {
  throw std::runtime_error("simulate: no loop for scenario " + std::string(scenario) +
                           " and seed " + std::to_string(seed) +
                           "; the family's ranges leave none, try another seed");
}

SimulatedLoop finish(const Draft& draft, Trajectory run, const Units& units,
                     std::string_view scenario, std::uint64_t seed, std::string_view kind,
                     std::string_view cause) {
  SimulatedLoop loop;
  loop.period_s = draft.setup.period_s;
  const double low = draft.setup.controller.low;
  const double high = draft.setup.controller.high;
  for (std::size_t t = 0; t < run.u.size(); ++t) {
    // Whole microseconds, so that 0.3 is not written as 0.30000000000000004.
    loop.t.push_back(std::round(static_cast<double>(t) * loop.period_s * 1e6) / 1e6);
    if (run.u[t] <= low || run.u[t] >= high) loop.truth.u_limited = true;
  }
  const auto rescale = [](std::vector<double>& signal, double scale, double offset) {
    for (double& value : signal) value = scale * value + offset;
  };
  rescale(run.u, units.u_scale, units.u_offset);
  rescale(run.x, units.u_scale, units.u_offset);
  rescale(run.y, units.y_scale, units.y_offset);
  rescale(run.sp, units.y_scale, units.y_offset);
  rescale(run.y_clean, units.y_scale, units.y_offset);
  loop.u = std::move(run.u);
  loop.x = std::move(run.x);
  loop.y = std::move(run.y);
  loop.sp = std::move(run.sp);
  loop.y_clean = std::move(run.y_clean);

  LoopTruth& truth = loop.truth;
  truth.scenario = scenario;
  truth.seed = seed;
  truth.kind = kind;
  truth.cause = cause;
  Friction friction = draft.friction;
  for (double* force : {&friction.static_ascending, &friction.static_descending,
                        &friction.kinetic_ascending, &friction.kinetic_descending}) {
    *force *= units.u_scale;
  }
  truth.stick_band_ascending = friction.stick_band_ascending();
  truth.stick_band_descending = friction.stick_band_descending();
  truth.slip_jump_ascending = friction.slip_jump_ascending();
  truth.slip_jump_descending = friction.slip_jump_descending();
  truth.valve = {draft.valve_model, friction, draft.setup.positioner_lag_s};
  truth.process = draft.setup.process;
  truth.process.gain *= units.y_scale / units.u_scale;
  truth.controller = draft.setup.controller;
  truth.controller.gain *= units.u_scale / units.y_scale;
  truth.controller.low = units.u_scale * low + units.u_offset;
  truth.controller.high = units.u_scale * high + units.u_offset;
  truth.controller.gap *= units.y_scale;
  truth.noise_std = draft.noise_std * units.y_scale;
  truth.noise_ceiling_percent = noise_ceiling_percent(loop.y, loop.y_clean);
  return loop;
}

}  // namespace workbench
