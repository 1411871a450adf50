// Loops whose valve is fine: what moves them instead.
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "support/real_loads/draft.hpp"
#include "workbench/recording/statistics.hpp"
#include "workbench/simulate/cycles.hpp"
#include "workbench/simulate/setpoint_moves.hpp"

namespace workbench::test {
namespace {

// The output of a sticking loop that oscillates by itself under a small real load of its
// own, standard deviation 1.
std::vector<double> draw_neighbour(Random& random, const std::vector<RealLoad>& loads,
                                   std::size_t samples, double least, double most) {
  const RealLoadPlan plan = draw_plan(random, LoopKind::kSticking, 0);
  RealLoadDraft neighbour;
  LoopSetup& setup = neighbour.draft.setup;
  if (!draw_tuned_loop(random, plan.type, neighbour.draft)) return {};
  const auto alone = draw_sticking_valve(random, plan, neighbour.draft);
  if (!alone || alone->period < least || alone->period > most) return {};
  setup.warm_up = 500;
  setup.samples = samples;
  const std::vector<double> load = draw_load(random, loads, neighbour);
  if (load.empty()) return {};
  add_load(setup.input_load, load, alone->x * random.log_uniform(0.03, 0.3));
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

// What moves the loop beside the real load; empty where it cannot be had.
std::vector<double> draw_main_load(Random& random, const RealLoadPlan& plan,
                                   const std::vector<RealLoad>& loads,
                                   const RealLoadDraft& loop) {
  const double thinning = static_cast<double>(plan.thinning());
  if (plan.cause == "sinusoid") {
    const double irregularity = random.chance(0.5) ? random.uniform(0.01, 0.06) : 0;
    return sinusoid(random, loop.total(), thinning * random.log_uniform(8, 80),
                    irregularity);
  }
  if (plan.cause == "neighbour") {
    return draw_neighbour(random, loads, loop.total(), 8 * thinning, 80 * thinning);
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
    main_load = draw_main_load(random, plan, loads, loop);
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

}  // namespace

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

}  // namespace workbench::test
