#include "support/real_load_loop.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "support/real_load_draft.hpp"
#include "workbench/simulate/cycles.hpp"
#include "workbench/simulate/noise.hpp"
#include "workbench/simulate/setpoint_moves.hpp"

namespace workbench::test {
namespace {

constexpr int kMostRedraws = 5000;
constexpr std::size_t kProbe = 2000;  // samples

// Any length that holds 5 to 60 cycles of `period`, if there is one; recorded samples
// between 600 and 4000.
void draw_length(Random& random, const RealLoadPlan& plan, double period, Draft& draft) {
  const double recorded_period = period / static_cast<double>(plan.thinning());
  double least = 600;
  double most = 4000;
  if (period > 0) {
    least = std::clamp(5.5 * recorded_period, least, most - 1);
    most = std::clamp(58 * recorded_period, least + 1, most);
  }
  draft.setup.samples =
      plan.thinning() * static_cast<std::size_t>(random.log_uniform(least, most));
  draft.setup.warm_up = 500 + static_cast<std::size_t>(4 * period);
}

void add_noise(Random& random, RealLoadDraft& loop, double y_size) {
  loop.draft.noise_std = y_size * random.log_uniform(0.005, 0.1);
  loop.draft.setup.noise = coloured_noise(random, loop.total(), 0, loop.draft.noise_std);
}

// What moves y in a loop, for loads to be measured against: standard deviations.
struct Movement {
  double x = 0;       // units of u
  double y = 0;       // units of y
  double period = 0;  // samples; 0 where the loop does not oscillate
};

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

// Sticks, and tends to a limit cycle.
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

// The output of a sticking loop that oscillates by itself, standard deviation 1.
std::vector<double> draw_neighbour(Random& random, std::size_t samples, double least,
                                   double most) {
  RealLoadPlan plan = draw_plan(random, LoopKind::kSticking, 0);
  RealLoadDraft neighbour;
  if (!draw_tuned_loop(random, plan.type, neighbour.draft)) return {};
  const auto alone = draw_sticking_valve(random, plan, neighbour.draft);
  if (!alone || alone->period < least || alone->period > most) return {};
  neighbour.draft.setup.warm_up = 500;
  neighbour.draft.setup.samples = samples;
  std::vector<double> y = run_draft(neighbour.draft).y;
  const double mean = mean_of(y);
  const double std = std_of(y);
  for (double& value : y) value = (value - mean) / std;
  return y;
}

// Slow against the recording: a line and a slow wave.
std::vector<double> draw_drift(Random& random, std::size_t samples) {
  const double length = static_cast<double>(samples);
  std::vector<double> drift = smooth_moves(random, samples, length);
  const double slope = random.sign() * random.uniform(0, 3) / length;
  for (std::size_t t = 0; t < samples; ++t) drift[t] += slope * static_cast<double>(t);
  const double mean = mean_of(drift);
  const double std = std_of(drift);
  for (double& value : drift) value = (value - mean) / std;
  return drift;
}

// What moves the loop beside the real load, at its input or output; empty for nothing.
std::vector<double> draw_main_load(Random& random, const RealLoadPlan& plan,
                                   const RealLoadDraft& loop) {
  const double thinning = static_cast<double>(plan.thinning());
  if (plan.cause == "sinusoid") {
    const double irregularity = random.chance(0.5) ? random.uniform(0.01, 0.06) : 0;
    return sinusoid(random, loop.total(), thinning * random.log_uniform(8, 80),
                    irregularity);
  }
  if (plan.cause == "neighbour") {
    return draw_neighbour(random, loop.total(), 8 * thinning, 80 * thinning);
  }
  return draw_drift(random, loop.total());
}

// Close to ringing for ever, or beyond and held by the limits of u.
bool tighten(Random& random, bool limited, Draft& draft) {
  const auto factor = ultimate_gain_factor(draft);
  if (!factor) return false;
  PiSettings& controller = draft.setup.controller;
  controller.gain *=
      *factor * (limited ? random.uniform(1.02, 1.3) : random.uniform(0.85, 0.98));
  if (limited) {
    controller.low = draft.setup.rest_u - random.uniform(3, 30);
    controller.high = draft.setup.rest_u + random.uniform(3, 30);
  }
  return true;
}

// Sizes everything by what it does to u, standard deviation `u_size` in all: the real
// load, what moves the loop beside it, the setpoint. False where there is no such thing.
bool put_movement(Random& random, const RealLoadPlan& plan,
                  const std::vector<RealLoad>& loads, double u_size,
                  RealLoadDraft& loop) {
  LoopSetup& setup = loop.draft.setup;
  const bool beside =
      plan.cause == "sinusoid" || plan.cause == "neighbour" || plan.cause == "drift";
  const bool sp_moves = plan.cause == "setpoint";
  const auto size_for = [&](const std::vector<double>& signal, bool at_output, double u) {
    const double answer = linear_answer(loop.draft, signal, at_output);
    return std::isfinite(answer) && answer > 0 ? u / answer : 0.0;
  };

  const std::vector<double> load = draw_load(random, loads, loop);
  if (load.empty()) return false;
  const bool at_output = random.chance(0.5);
  loop.truth.load_at = at_output ? "output" : "input";
  loop.truth.load_share = beside || sp_moves ? random.log_uniform(0.03, 0.5) : 1;
  const double load_size = size_for(load, at_output, u_size * loop.truth.load_share);
  if (load_size == 0) return false;

  std::vector<double> main_load;
  const bool main_at_output = random.chance(0.5);
  double main_size = 0;
  if (beside) {
    main_load = draw_main_load(random, plan, loop);
    if (main_load.empty()) return false;
    main_size = size_for(main_load, main_at_output, u_size);
    if (main_size == 0) return false;
  }

  if (sp_moves && random.chance(0.4)) {
    loop.truth.setpoint = "moving";
    setup.setpoint = draw_moves(random, loop.total(), random.log_uniform(20, 300));
  } else {
    setup.setpoint = draw_setpoint(random, loop, sp_moves);
  }
  // The setpoint does to u what an output load of opposite sign does.
  const double sp_u = sp_moves ? u_size : u_size * random.log_uniform(0.1, 1);
  const double reach = size_for(setup.setpoint, true, sp_u);
  for (double& value : setup.setpoint) value *= reach;

  add_load(at_output ? setup.output_load : setup.input_load, load, load_size);
  add_load(main_at_output ? setup.output_load : setup.input_load, main_load, main_size);
  return true;
}

// A limit cycle between the limits of u; a real load, small against it, moves it.
bool put_limit_cycle(Random& random, const std::vector<RealLoad>& loads,
                     RealLoadDraft& loop) {
  LoopSetup& setup = loop.draft.setup;
  const std::vector<double> load = draw_load(random, loads, loop);
  if (load.empty()) return false;
  loop.truth.load_at = "input";
  loop.truth.load_share = random.log_uniform(0.03, 0.5);
  loop.truth.setpoint = "constant";
  const double range =
      std::min(setup.controller.high - setup.rest_u, setup.rest_u - setup.controller.low);
  add_load(setup.input_load, load, loop.truth.load_share * range / 2);
  return true;
}

std::optional<RealLoadLoop> draw_healthy(Random& random, const RealLoadPlan& plan,
                                         const std::vector<RealLoad>& loads) {
  RealLoadDraft loop;
  LoopSetup& setup = loop.draft.setup;
  if (!draw_tuned_loop(random, plan.type, loop.draft)) return std::nullopt;
  bool limited = false;
  if (plan.cause == "tight_tuning") {
    limited = random.chance(0.25);
    if (!tighten(random, limited, loop.draft)) return std::nullopt;
  }
  draw_length(random, plan, 0, loop.draft);
  const double u_size = random.log_uniform(0.5, 10);
  const bool moves = limited ? put_limit_cycle(random, loads, loop)
                             : put_movement(random, plan, loads, u_size, loop);
  if (!moves) return std::nullopt;

  const double y_size = std_of(run_with_linear_valve(loop.draft).y);
  if (!std::isfinite(y_size) || !(y_size > 0)) return std::nullopt;
  if (plan.cause == "sensor") {
    const double band = y_size * random.log_uniform(0.5, 3);
    setup.sensor = friction_from_s_j(band, band * random.uniform(0.2, 1));
  } else if (random.chance(0.12)) {
    setup.controller.gap = y_size * random.uniform(0.1, 0.8);
  }
  add_noise(random, loop, y_size);
  return record_loop(random, plan, loop);
}

}  // namespace

RealLoadLoop real_load_loop(LoopKind kind, std::uint64_t seed,
                            const std::vector<RealLoad>& loads) {
  if (loads.empty()) {
    throw std::invalid_argument(
        "real_load_loop: expected at least one load, found none; read them with "
        "read_real_loads from a folder that holds the recordings");
  }
  const bool sticking = kind == LoopKind::kSticking;
  Random random(sticking ? "real-load-sticking" : "real-load-healthy", seed);
  const RealLoadPlan plan = draw_plan(random, kind, seed);
  for (int redraw = 0; redraw < kMostRedraws; ++redraw) {
    auto loop =
        sticking ? draw_sticking(random, plan, loads) : draw_healthy(random, plan, loads);
    if (loop) return std::move(*loop);
  }
  throw std::runtime_error("real_load_loop: no loop for seed " + std::to_string(seed) +
                           " (" + plan.cause + ", " + plan.motion + ", " +
                           std::string(name(plan.historian)) +
                           "); the ranges leave none, try another seed");
}

nlohmann::json truth_json(const RealLoadLoop& loop) {
  nlohmann::json json = truth_json(loop.recorded.truth);
  const RealLoadTruth& truth = loop.truth;
  json["sticks"] = truth.motion != "none";
  json["motion"] = truth.motion;
  json["strokes"] = truth.strokes;
  json["historian"] = name(truth.historian);
  json["load"] = truth.load;
  json["load_at"] = truth.load_at;
  json["load_share"] = truth.load_share;
  json["setpoint"] = truth.setpoint;
  json["gap"] = truth.gap;
  json["cycles"] = truth.cycles;
  json["band_over_swing"] = truth.band_over_swing;
  json["oracle_nats"] = truth.oracle_nats;
  json["period_s"] = loop.recorded.period_s;
  return json;
}

}  // namespace workbench::test
