#include "support/real_loads/draft.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "support/oracle/nats.hpp"
#include "workbench/simulate/cycles.hpp"
#include "workbench/simulate/noise.hpp"

namespace workbench::test {
namespace {

constexpr double kMostAtLimit = 0.25;  // share of the samples

LoopType draw_type(Random& random) {
  const double draw = random.uniform();
  if (draw < 0.2) return LoopType::kLevel;
  return draw < 0.6 ? LoopType::kFlow : LoopType::kSlow;
}

Historian draw_historian(Random& random) {
  const double draw = random.uniform();
  if (draw < 0.3) return Historian::kNone;
  if (draw < 0.46) return Historian::kBoxcar;
  if (draw < 0.62) return Historian::kSwingingDoor;
  if (draw < 0.78) return Historian::kQuantised;
  return draw < 0.9 ? Historian::kEverySecond : Historian::kJitter;
}

bool usable(const Draft& draft, const Trajectory& run) {
  const PiSettings& controller = draft.setup.controller;
  const auto at_limit = std::ranges::count_if(
      run.u, [&](double u) { return u <= controller.low || u >= controller.high; });
  const auto finite = [](const std::vector<double>& signal) {
    return std::ranges::all_of(signal, [](double v) { return std::isfinite(v); });
  };
  return finite(run.y) && finite(run.u) && swing_of(run.u) > 0 && swing_of(run.y) > 0 &&
         static_cast<double>(at_limit) < kMostAtLimit * static_cast<double>(run.u.size());
}

// Every recorded loop is as likely, however many recordings there are of it.
const RealLoad& draw_recording(Random& random, const std::vector<RealLoad>& loads) {
  std::set<std::string> loops;
  for (const RealLoad& load : loads) loops.insert(load.loop);
  const auto loop =
      std::next(loops.begin(), random.integer(0, static_cast<int>(loops.size()) - 1));
  std::vector<const RealLoad*> recordings;
  for (const RealLoad& load : loads) {
    if (load.loop == *loop) recordings.push_back(&load);
  }
  const int which = random.integer(0, static_cast<int>(recordings.size()) - 1);
  return *recordings[static_cast<std::size_t>(which)];
}

// Median of what u swings in stretches of one cycle.
double usual_swing(const std::vector<double>& u, double period) {
  const auto length =
      std::clamp<std::size_t>(static_cast<std::size_t>(std::lround(period)), 2, u.size());
  std::vector<double> swings;
  for (std::size_t from = 0; from + length <= u.size(); from += length) {
    swings.push_back(swing_of(std::span(u).subspan(from, length)));
  }
  std::ranges::sort(swings);
  return swings[swings.size() / 2];
}

}  // namespace

RealLoadPlan draw_plan(Random& random, LoopKind kind, std::uint64_t seed) {
  RealLoadPlan plan;
  plan.kind = kind;
  plan.seed = seed;
  plan.type = draw_type(random);
  plan.historian = draw_historian(random);
  if (kind == LoopKind::kHealthy) {
    constexpr std::array kCauses{"tight_tuning", "load",  "setpoint", "sinusoid",
                                 "neighbour",    "drift", "sensor"};
    plan.cause = kCauses[static_cast<std::size_t>(random.integer(0, 6))];
    return plan;
  }
  const double motion = random.uniform();
  plan.motion = motion < 0.3   ? "slides"
                : motion < 0.6 ? "stops"
                : motion < 0.9 ? "resticks"
                               : "backlash";
  plan.cause = plan.motion == "backlash" ? "backlash" : "stiction";
  const double strokes = random.uniform();
  plan.strokes = strokes < 0.6 || plan.motion == "backlash" ? "equal"
                 : strokes < 0.8                            ? "different"
                                                            : "one_sided";
  return plan;
}

bool draw_tuned_loop(Random& random, LoopType type, Draft& draft) {
  draw_loop(random, type, draft);
  draft.setup.controller.gain *= random.log_uniform(0.4, 2.5);
  draft.setup.controller.reset_time_s *= random.log_uniform(0.4, 2.5);
  return settles(draft);
}

std::optional<double> ultimate_gain_factor(const Draft& draft) {
  double stable = 1;
  double unstable = 200;
  if (ringing_growth(draft, unstable) < 1) return std::nullopt;
  for (int i = 0; i < 16; ++i) {
    const double middle = std::sqrt(stable * unstable);
    (ringing_growth(draft, middle) < 1 ? stable : unstable) = middle;
  }
  return stable;
}

Friction draw_friction(Random& random, const RealLoadPlan& plan) {
  const double band = random.log_uniform(1, 12);
  if (plan.motion == "backlash") return friction_from_s_j(band, 0);
  if (plan.strokes == "one_sided") {
    return random.chance(0.5) ? friction_from_bands(band, 0, 0)
                              : friction_from_bands(0, band, 0);
  }
  if (plan.strokes == "different") {
    const double smaller = band * random.uniform(0.3, 0.8);
    const double deadband = smaller * random.uniform(0, 0.8);
    return random.chance(0.5) ? friction_from_bands(band, smaller, deadband)
                              : friction_from_bands(smaller, band, deadband);
  }
  return friction_from_s_j(band, band * random.uniform(0.15, 1));
}

std::string_view valve_model(std::string_view motion) {
  if (motion == "slides") return "coasting";
  if (motion == "stops") return "sliding";
  if (motion == "resticks") return "he";
  return motion == "backlash" ? "backlash" : "linear";
}

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

std::vector<double> draw_load(Random& random, const std::vector<RealLoad>& loads,
                              RealLoadDraft& loop) {
  const RealLoad& load = draw_recording(random, loads);
  const double samples = static_cast<double>(loop.total());
  // At most three times to and fro.
  const double least = samples / (3 * static_cast<double>(load.values.size()));
  loop.truth.load = load.name;
  return cut_load(random, load, loop.total(),
                  std::max(least, random.log_uniform(0.3, 6)));
}

void add_load(std::vector<double>& place, const std::vector<double>& load, double size) {
  place.resize(std::max(place.size(), load.size()), 0.0);
  for (std::size_t t = 0; t < load.size(); ++t) place[t] += size * load[t];
}

double linear_answer(const Draft& draft, const std::vector<double>& load,
                     bool at_output) {
  Draft alone = draft;
  LoopSetup& setup = alone.setup;
  setup.controller.low = -1e300;
  setup.controller.high = 1e300;
  setup.controller.gap = 0;
  setup.sensor = {};
  setup.setpoint.clear();
  setup.noise.clear();
  setup.input_bias = 0;
  setup.input_load.clear();
  setup.output_load.clear();
  (at_output ? setup.output_load : setup.input_load) = load;
  return std_of(run_with_linear_valve(alone).u);
}

std::vector<double> draw_setpoint(Random& random, RealLoadDraft& loop, bool moves) {
  const double draw = moves ? random.uniform(0.7, 1) : random.uniform();
  const std::size_t start = loop.draft.setup.warm_up;
  const double samples = static_cast<double>(loop.draft.setup.samples);
  std::vector<double> setpoint(loop.total(), 0.0);
  const auto step = [&](double place, double level) {
    const auto from = start + static_cast<std::size_t>(place * samples);
    std::fill(setpoint.begin() + static_cast<std::ptrdiff_t>(from), setpoint.end(),
              level);
  };
  if (draw < 0.7) {
    loop.truth.setpoint = "constant";
  } else if (draw < 0.85) {
    loop.truth.setpoint = "few_moves";
    std::vector<double> places(static_cast<std::size_t>(random.integer(2, 6)));
    for (double& place : places) place = random.uniform(0.02, 0.98);
    std::ranges::sort(places);
    for (const double place : places) step(place, random.uniform(-1, 1));
  } else {
    loop.truth.setpoint = "step_test";
    const double up = random.sign();
    step(random.uniform(0.1, 0.2), up);
    step(random.uniform(0.35, 0.45), -up * random.uniform(0.3, 1));
    step(random.uniform(0.65, 0.75), 0);
  }
  return setpoint;
}

std::optional<RealLoadLoop> record_loop(Random& random, const RealLoadPlan& plan,
                                        RealLoadDraft& loop) {
  Trajectory run = run_draft(loop.draft);
  if (!usable(loop.draft, run)) return std::nullopt;
  const Cycles cycles = measure_cycles(run.u);
  const double thinning = static_cast<double>(plan.thinning());
  const bool any_cycle = plan.cause == "setpoint" || plan.cause == "drift";
  if (!any_cycle) {
    if (cycles.count < 5 || cycles.count > 60) return std::nullopt;
    if (cycles.period < 8 * thinning || cycles.period > 80 * thinning) {
      return std::nullopt;
    }
  }
  const Friction& friction = loop.draft.friction;
  const double band =
      std::max(friction.stick_band_ascending(), friction.stick_band_descending());
  if (plan.kind == LoopKind::kSticking) {
    loop.truth.band_over_swing = band / usual_swing(run.u, cycles.period);
    if (swing_of(run.x) < 0.1 * band) return std::nullopt;
  }
  loop.truth.cycles = cycles.count;
  loop.truth.motion = plan.motion;
  loop.truth.strokes = plan.strokes;
  loop.truth.historian = plan.historian;

  const Units units = draw_units(random, swing_of(run.y));
  loop.truth.gap = loop.draft.setup.controller.gap * units.y_scale;
  const bool sticking = plan.kind == LoopKind::kSticking;
  RealLoadLoop out{finish(loop.draft, std::move(run), units,
                          sticking ? "real-load-sticking" : "real-load-healthy",
                          plan.seed, sticking ? plan.cause : "no_stiction", plan.cause),
                   loop.truth};
  SimulatedLoop& recorded = out.recorded;
  if (!any_cycle) {
    recorded.truth.oscillation_period_s = cycles.period * recorded.period_s;
  }
  std::vector<double> sampled_u = recorded.u;
  record(random, plan.historian, recorded);
  if (plan.historian == Historian::kEverySecond) sampled_u = recorded.u;
  if (!(swing_of(recorded.u) > 0) || !(swing_of(recorded.y) > 0)) return std::nullopt;
  out.truth.oracle_nats = std::min(oracle_nats(recorded.y, recorded.u, recorded.x),
                                   oracle_nats(recorded.y, sampled_u, recorded.x));
  if (sticking && out.truth.oracle_nats < kLeastOracleNats) return std::nullopt;
  return out;
}

}  // namespace workbench::test
