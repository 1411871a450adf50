#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "workbench/simulate/cycles.hpp"
#include "workbench/simulate/draft.hpp"
#include "workbench/simulate/families.hpp"
#include "workbench/simulate/noise.hpp"
#include "workbench/simulate/setpoint_moves.hpp"

namespace workbench {
namespace {

using Maybe = std::optional<SimulatedLoop>;

// Calls `attempt(random)` until it returns a recording.
template <class Attempt>
SimulatedLoop redraw(std::string_view scenario, std::uint64_t seed, Attempt attempt) {
  Random random(scenario, seed);
  for (int i = 0; i < kMostRedraws; ++i) {
    if (Maybe loop = attempt(random)) return std::move(*loop);
  }
  no_loop(scenario, seed);
}

// The same with a loop that settles.
template <class Attempt>
SimulatedLoop redraw_settled(std::string_view scenario, std::uint64_t seed,
                             Attempt attempt) {
  return redraw(scenario, seed, [&](Random& random) -> Maybe {
    Draft draft;
    draw_loop(random, draw_loop_type(random), draft);
    return settles(draft) ? attempt(random, draft) : std::nullopt;
  });
}

void draw_length(Random& random, Draft& draft) {
  draft.setup.samples = static_cast<std::size_t>(random.log_uniform(600, 4000));
  draft.setup.warm_up = 1000;
}

std::size_t total(const Draft& draft) {
  return draft.setup.warm_up + draft.setup.samples;
}

bool touches_limits(const Draft& draft, const Trajectory& run) {
  const auto [low, high] = std::ranges::minmax_element(run.u);
  return *low <= draft.setup.controller.low || *high >= draft.setup.controller.high;
}

// A load of unit size on the process input or output, made so large that u
// swings by `swing` percent. The loop is linear, so one run tells the size.
void put_load(Random& random, Draft& draft, std::vector<double> load, double swing) {
  LoopSetup& setup = draft.setup;
  const bool at_input = setup.process.integrating || random.chance(0.5);
  std::vector<double>& place = at_input ? setup.input_load : setup.output_load;
  if (!at_input) scale(load, std::abs(setup.process.gain));
  place = std::move(load);
  scale(place, swing / free_swing(draft));
}

void put_setpoint(Draft& draft, std::vector<double> motion, double swing) {
  draft.setup.setpoint = std::move(motion);
  scale(draft.setup.setpoint, swing / free_swing(draft));
}

// Noise for a signal-to-noise ratio, amplitude over standard deviation.
void put_noise(Random& random, Draft& draft, double least_ratio, double most_ratio) {
  const Trajectory quiet = run_with_linear_valve(draft);
  const double ratio = random.log_uniform(least_ratio, most_ratio);
  draw_noise(random, total(draft), swing_of(quiet.y) / 2 / ratio, draft);
}

Maybe finish_no_stiction(Random& random, const Draft& draft, std::string_view scenario,
                         std::uint64_t seed, std::string_view cause) {
  Trajectory run = run_draft(draft);
  if (cause != "tight_tuning" && touches_limits(draft, run)) return std::nullopt;
  const Units units = draw_units(random, swing_of(run.y));
  return finish(draft, std::move(run), units, scenario, seed, "no_stiction", cause);
}

}  // namespace

SimulatedLoop external_sinusoid(std::string_view scenario, std::uint64_t seed) {
  return redraw_settled(scenario, seed, [&](Random& random, Draft& draft) -> Maybe {
    const double period = random.log_uniform(15, 300);
    const double length = std::clamp(period * random.log_uniform(5, 40), 600.0, 4000.0);
    if (length < 5 * period || length > 40 * period) return std::nullopt;
    draft.setup.samples = static_cast<std::size_t>(length);
    draft.setup.warm_up = 1000;
    const double irregularity = random.chance(0.5) ? random.uniform(0.01, 0.06) : 0;
    put_load(random, draft, sinusoid(random, total(draft), period, irregularity),
             random.log_uniform(2, 40));
    put_noise(random, draft, 3, 50);
    auto loop = finish_no_stiction(random, draft, scenario, seed, "external_sinusoid");
    if (loop) loop->truth.oscillation_period_s = period * loop->period_s;
    return loop;
  });
}

SimulatedLoop tight_tuning(std::string_view scenario, std::uint64_t seed) {
  return redraw_settled(scenario, seed, [&](Random& random, Draft& draft) -> Maybe {
    LoopSetup& setup = draft.setup;
    double stable = 1;
    double unstable = 200;
    if (ringing_growth(draft, unstable) < 1) return std::nullopt;
    for (int i = 0; i < 30; ++i) {
      const double middle = std::sqrt(stable * unstable);
      (ringing_growth(draft, middle) < 1 ? stable : unstable) = middle;
    }
    const bool limited = random.chance(0.4);
    setup.controller.gain *=
        stable * (limited ? random.uniform(1.02, 1.4) : random.uniform(0.85, 0.98));
    setup.warm_up = 1500;
    setup.samples = 4000;
    double period = 0;
    if (limited) {
      setup.controller.low = setup.rest_u - random.uniform(3, 30);
      setup.controller.high = setup.rest_u + random.uniform(3, 30);
      setup.setpoint = {1e-3 * setup.process.gain};
      if (setup.process.integrating) setup.setpoint = {1e-3};
    } else {
      // The noise goes through the controller, so that its gain bounds it.
      draw_noise(random, total(draft), 1 / std::abs(setup.controller.gain), draft);
      setup.input_load = coloured_noise(random, total(draft), random.uniform(0, 0.9), 1);
    }
    const Trajectory probe = run_with_linear_valve(draft);
    const Cycles cycle = measure_cycles(probe.y_clean);
    if (cycle.count < 4 || cycle.period < 10 || cycle.spread > 0.5) return std::nullopt;
    period = cycle.period;
    const double length = std::clamp(period * random.log_uniform(6, 60), 600.0, 4000.0);
    if (length < 5 * period || length > 80 * period) return std::nullopt;
    setup.samples = static_cast<std::size_t>(length);
    if (limited) {
      put_noise(random, draft, 5, 60);
    } else {
      const double size = random.log_uniform(3, 30) / swing_of(probe.u);
      scale(setup.noise, size * random.log_uniform(0.1, 1));
      draft.noise_std = std_of(setup.noise);
      scale(setup.input_load, size);
    }
    auto loop = finish_no_stiction(random, draft, scenario, seed, "tight_tuning");
    if (!loop) return loop;
    const Cycles seen = measure_cycles(loop->y_clean);
    if (seen.count < 4 || (!limited && loop->truth.u_limited)) return std::nullopt;
    loop->truth.oscillation_period_s = seen.period * loop->period_s;
    return loop;
  });
}

SimulatedLoop random_load(std::string_view scenario, std::uint64_t seed) {
  return redraw_settled(scenario, seed, [&](Random& random, Draft& draft) -> Maybe {
    draw_length(random, draft);
    // A memory of 5 to 2000 samples.
    const double pole = 1 - 1 / random.log_uniform(5, 2000);
    put_load(random, draft, coloured_noise(random, total(draft), pole, 1),
             random.log_uniform(2, 40));
    put_noise(random, draft, 3, 50);
    return finish_no_stiction(random, draft, scenario, seed, "random_load");
  });
}

SimulatedLoop load_and_noise(std::string_view scenario, std::uint64_t seed) {
  return redraw_settled(scenario, seed, [&](Random& random, Draft& draft) -> Maybe {
    draw_length(random, draft);
    const std::size_t samples = total(draft);
    const double pole = 1 - 1 / random.log_uniform(3, 300);
    std::vector<double> load = coloured_noise(random, samples, pole, 1);
    const std::vector<double> steps =
        step_moves(random, samples, random.log_uniform(100, 1000));
    const double step_size = random.uniform(0.5, 3);
    const double drift = random.normal() * 2 / static_cast<double>(samples);
    for (std::size_t t = 0; t < samples; ++t) {
      load[t] += step_size * steps[t] + drift * static_cast<double>(t);
    }
    put_load(random, draft, std::move(load), random.log_uniform(2, 40));
    put_noise(random, draft, 1.5, 6);
    return finish_no_stiction(random, draft, scenario, seed, "random_load");
  });
}

SimulatedLoop setpoint_moves(std::string_view scenario, std::uint64_t seed) {
  return redraw_settled(scenario, seed, [&](Random& random, Draft& draft) -> Maybe {
    draw_length(random, draft);
    put_setpoint(draft, draw_moves(random, total(draft), random.log_uniform(20, 300)),
                 random.log_uniform(3, 50));
    put_noise(random, draft, 3, 50);
    return finish_no_stiction(random, draft, scenario, seed, "setpoint");
  });
}

SimulatedLoop noise_only(std::string_view scenario, std::uint64_t seed) {
  return redraw_settled(scenario, seed, [&](Random& random, Draft& draft) -> Maybe {
    draw_length(random, draft);
    const double moves_u = random.log_uniform(0.05, 3);
    draw_noise(random, total(draft), moves_u / std::abs(draft.setup.controller.gain),
               draft);
    return finish_no_stiction(random, draft, scenario, seed, "healthy");
  });
}

SimulatedLoop quantised(std::string_view scenario, std::uint64_t seed) {
  return redraw_settled(scenario, seed, [&](Random& random, Draft& draft) -> Maybe {
    draw_length(random, draft);
    const double swing = random.log_uniform(2, 40);
    if (random.chance(0.5)) {
      const double pole = 1 - 1 / random.log_uniform(20, 500);
      put_load(random, draft, coloured_noise(random, total(draft), pole, 1), swing);
    } else {
      put_setpoint(draft, draw_moves(random, total(draft), random.log_uniform(30, 300)),
                   swing);
    }
    put_noise(random, draft, 10, 200);
    const Trajectory smooth = run_with_linear_valve(draft);
    const int which = random.integer(0, 2);
    if (which != 1)
      draft.setup.y_resolution = swing_of(smooth.y) / random.log_uniform(4, 25);
    if (which != 0)
      draft.setup.u_resolution = swing_of(smooth.u) / random.log_uniform(4, 25);
    return finish_no_stiction(random, draft, scenario, seed, "quantised");
  });
}

SimulatedLoop healthy_positioner(std::string_view scenario, std::uint64_t seed) {
  return redraw(scenario, seed, [&](Random& random) -> Maybe {
    Draft draft;
    draw_loop(random, draw_loop_type(random), draft);
    draft.setup.positioner_lag_s = draft.setup.period_s * random.uniform(0.2, 2);
    if (!settles(draft)) return std::nullopt;
    draw_length(random, draft);
    const double swing = random.log_uniform(3, 40);
    std::string_view cause;
    switch (random.integer(0, 2)) {
      case 0:
        cause = "setpoint";
        put_setpoint(draft, draw_moves(random, total(draft), random.log_uniform(30, 300)),
                     swing);
        break;
      case 1: {
        cause = "external_sinusoid";
        const double period =
            static_cast<double>(draft.setup.samples) / random.uniform(5, 40);
        put_load(random, draft, sinusoid(random, total(draft), period, 0), swing);
        break;
      }
      default: {
        cause = "random_load";
        const double pole = 1 - 1 / random.log_uniform(10, 500);
        put_load(random, draft, coloured_noise(random, total(draft), pole, 1), swing);
        break;
      }
    }
    put_noise(random, draft, 5, 50);
    draft.valve_model = "backlash";
    draft.friction = friction_from_s_j(swing * random.uniform(0.002, 0.005), 0);
    return finish_no_stiction(random, draft, scenario, seed, cause);
  });
}

}  // namespace workbench
