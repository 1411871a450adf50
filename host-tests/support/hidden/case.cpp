#include "support/hidden/case.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "support/hidden/random.hpp"
#include "support/hidden/textbook.hpp"

namespace hidden {
namespace {

constexpr int kFewestCycles = 8;
/// A quiet recording may show this much of the effect, as a share of the noise.
constexpr double kMostWhenQuiet = 0.05;

bool has(const CaseKey& key, Effect effect) {
  return std::find(key.effects.begin(), key.effects.end(), effect) != key.effects.end();
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) /
         static_cast<double>(values.size());
}

double standard_deviation(const std::vector<double>& values) {
  const double centre = mean(values);
  double squares = 0;
  for (const double v : values) {
    squares += (v - centre) * (v - centre);
  }
  return std::sqrt(squares / static_cast<double>(values.size()));
}

/// Crossings of the mean, with hysteresis.
int crossings(const std::vector<double>& values) {
  const double centre = mean(values);
  const double band = 0.3 * standard_deviation(values);
  int count = 0;
  int side = 0;
  for (const double v : values) {
    const int now = v > centre + band ? 1 : v < centre - band ? -1 : side;
    count += side != 0 && now != side ? 1 : 0;
    side = now;
  }
  return count;
}

/// Lambda tuning on the first lag; the other lags and the dead time slow it down.
void tune_pi(const CaseKey& key, const Scale& scale, Random& random, LoopSetup& setup) {
  const ProcessPhysics& process = setup.process;
  const double later = process.dead_time_s + process.second_lag_s + process.sensor_lag_s +
                       setup.valve.positioner_lag_s + process.ring_period_s / 2 +
                       2 * process.opposite_share * scale.lag_s;
  double slowness = random.chance(0.2) ? 0.25 : random.uniform(0.4, 1.2);
  if (key.excitation == Excitation::kQuiet) {
    slowness = random.uniform(2, 4);
  } else if (key.excitation == Excitation::kLimitCycle) {
    slowness = random.uniform(0.5, 1.2);
  }
  const double lambda = std::max(slowness * scale.lag_s, later);
  setup.controller.gain = scale.lag_s / (process.gain * (lambda + later));
  setup.controller.reset_s = process.integrating ? 4 * (lambda + later) : scale.lag_s;
  if (key.excitation == Excitation::kLimitCycle) {
    setup.controller.reset_s *= random.uniform(0.3, 0.8);
  }
}

void draw_controller(const CaseKey& key, const Scale& scale, Random& random,
                     LoopSetup& setup) {
  tune_pi(key, scale, random, setup);
  if (key.excitation != Excitation::kLimitCycle || has(key, Effect::kStiction)) {
    return;
  }
  const bool many_values = has(key, Effect::kBacklash) || has(key, Effect::kSaturation) ||
                           has(key, Effect::kCharacteristic) ||
                           has(key, Effect::kNonlinearGain) ||
                           has(key, Effect::kOverflow) || has(key, Effect::kReadingEnd) ||
                           (key.effects.empty() && random.chance(0.5));
  if (many_values) {
    setup.controller.kind = ControllerKind::kFloating;
    setup.controller.ramp_rate = scale.swing_u / (scale.lag_s * random.uniform(0.5, 1.5));
    setup.controller.hysteresis = scale.swing_y * random.uniform(0.5, 0.8);
  } else {
    setup.controller.kind = ControllerKind::kOnOff;
    setup.controller.swing = scale.swing_u;
    setup.controller.centre_offset = scale.swing_u * random.uniform(-0.3, 0.3);
    setup.controller.hysteresis = scale.swing_y * random.uniform(0.2, 0.4);
  }
}

/// Random levels within ±swing, each at least 0.3 swings from the one before.
void draw_setpoint(const CaseKey& key, const Scale& scale, Random& random,
                   LoopSetup& setup) {
  const std::size_t n = setup.warm_up + setup.samples;
  setup.setpoint.clear();
  const bool cycle = key.excitation == Excitation::kLimitCycle;
  const bool moved = !cycle || has(key, Effect::kIntegrating) ||
                     has(key, Effect::kBacklash) || has(key, Effect::kNonlinearGain) ||
                     has(key, Effect::kSlowTail);
  if (key.excitation == Excitation::kQuiet || !moved) {
    const double stuck_off = has(key, Effect::kStiction) && cycle
                                 ? random.uniform(0.1, 0.5) * random.sign()
                                 : 0;
    setup.setpoint.assign(n, stuck_off * scale.swing_y);
    return;
  }
  const double closed_loop_s = scale.lag_s * scale.lag_s /
                               (std::abs(setup.controller.gain) * scale.swing_y) *
                               scale.swing_u;
  double level = 0;
  while (setup.setpoint.size() < n) {
    const double hold = closed_loop_s / setup.period_s * random.uniform(2.5, 6);
    const double samples =
        cycle ? random.uniform(100, 200) : std::clamp(hold, 20.0, 120.0);
    double next = level;
    while (std::abs(next - level) < 0.3 * scale.swing_y) {
      next = scale.swing_y * random.uniform(-1, 1);
    }
    level = next;
    setup.setpoint.insert(setup.setpoint.end(), static_cast<std::size_t>(samples), level);
  }
  setup.setpoint.resize(n);
}

LoopSetup draw_loop(const CaseKey& key, int attempt, Scale& scale) {
  std::string label(name_of(key.excitation));
  for (const Effect effect : key.effects) {
    label += code_of(effect);
  }
  label += key.beyond_reach ? " beyond reach" : "";
  Random random(label, key.seed * 1000 + static_cast<std::uint64_t>(attempt));

  constexpr double kPeriods[] = {0.5, 1, 2, 5};
  LoopSetup setup;
  setup.period_s = kPeriods[static_cast<std::size_t>(4 * random.uniform())];
  setup.samples = key.samples;
  setup.warm_up = key.excitation == Excitation::kLimitCycle ? 600 : 60;
  setup.rest_u = random.uniform(35, 65);
  const double unit = random.log_uniform(0.1, 10);
  setup.rest_y = unit * random.uniform(20, 200);
  scale.lag_s = setup.period_s * random.log_uniform(10, 30);
  scale.swing_u = random.uniform(8, 15);
  setup.process.first_lag_s = scale.lag_s;
  setup.process.gain = unit * random.uniform(0.5, 2) * (random.chance(0.3) ? -1 : 1);
  scale.swing_y = std::abs(setup.process.gain) * scale.swing_u;
  scale.narrow = key.excitation == Excitation::kLimitCycle;

  for (const Effect effect : key.effects) {
    draw_effect(effect, scale, random, setup);
  }
  draw_controller(key, scale, random, setup);
  draw_setpoint(key, scale, random, setup);
  for (const Effect effect : key.effects) {
    if (!is_limit(effect)) {
      continue;
    }
    if (key.excitation == Excitation::kQuiet) {
      // Where a swing would reach it.
      LoopSetup swinging = setup;
      CaseKey steps = key;
      steps.excitation = Excitation::kSetpointSteps;
      draw_setpoint(steps, scale, random, swinging);
      draw_limit(effect, run_loop(swinging), true, random, setup);
    } else {
      draw_limit(effect, run_loop(setup), !key.beyond_reach, random, setup);
    }
  }
  Random noise("noise " + label, key.seed);
  setup.noise.resize(setup.warm_up + setup.samples);
  for (double& draw : setup.noise) {
    draw = noise.normal();
  }
  return setup;
}

double signal_std(const LoopSetup& setup, const Trace& trace) {
  return standard_deviation(recorded(setup, trace.sensed));
}

bool has_ratio(const CaseKey& key, const LoopSetup& setup, const Trace& trace) {
  const double wanted = signal_std(setup, trace) / key.signal_to_noise;
  return std::abs(setup.noise_std - wanted) <= 0.05 * wanted;
}

/// Sets the noise and runs the loop. The noise changes the signal it is measured against,
/// hence the passes.
Trace run_with_noise(const CaseKey& key, const Scale& scale, LoopSetup& setup) {
  constexpr int kPasses = 8;
  const bool quiet = key.excitation == Excitation::kQuiet;
  setup.noise_std = quiet ? scale.swing_y / 2 / key.signal_to_noise : 0;
  Trace trace = run_loop(setup);
  for (int pass = 0; !quiet && pass < kPasses && !has_ratio(key, setup, trace); ++pass) {
    setup.noise_std = signal_std(setup, trace) / key.signal_to_noise;
    trace = run_loop(setup);
  }
  return trace;
}

/// Part of the effect that the textbook model cannot take over, rms, in units of y.
double irreducible(const LoopSetup& setup, const Trace& trace, Effect effect,
                   const std::vector<Effect>& all) {
  LoopSetup plain = setup;
  for (const Effect one : all) {
    plain = without(plain, one);
  }
  const Trace base = run_loop(plain, &trace.u);
  std::vector<double> sum = base.sensed;
  if (is_recorded(effect)) {
    for (std::size_t k = 0; k < sum.size(); ++k) {
      sum[k] += trace.y[k] - trace.sensed[k] - setup.noise_std * setup.noise[k];
    }
  } else {
    const Trace rest = run_loop(without(setup, effect), &trace.u);
    for (std::size_t k = 0; k < sum.size(); ++k) {
      sum[k] += trace.sensed[k] - rest.sensed[k];
    }
  }
  return textbook_misfit(recorded(setup, trace.u), recorded(setup, sum));
}

/// The cycle must be the loop's own: not one that an external sinusoid imposes.
bool cycles_by_itself(const LoopSetup& setup, const Trace& trace) {
  const int count = crossings(recorded(setup, trace.sensed));
  if (count < 2 * kFewestCycles) {
    return false;
  }
  const double period_s = 2 * setup.period_s * static_cast<double>(setup.samples) /
                          static_cast<double>(count);
  const double ratio = setup.loads.sinusoid_period_s / period_s;
  return setup.loads.sinusoid == 0 || ratio < 0.85 || ratio > 1.18;
}

/// The loop is under control: y stays in the range that it was meant for, u off the
/// limits of the controller most of the time, and no tank is drawn below its bottom.
bool sensible(const LoopSetup& setup, const Trace& trace, const Scale& scale) {
  const std::vector<double> u = recorded(setup, trace.u);
  const auto at_limit = std::count_if(u.begin(), u.end(), [&](double value) {
    return value <= setup.controller.low || value >= setup.controller.high;
  });
  const std::vector<double> y = recorded(setup, trace.sensed);
  const auto off = std::count_if(y.begin(), y.end(), [&](double value) {
    return std::abs(value - setup.rest_y) > 4 * scale.swing_y;
  });
  return at_limit * 3 < static_cast<long>(setup.samples) && off == 0 && !trace.ran_dry;
}

bool accept(const CaseKey& key, const Scale& scale, HiddenCase& out) {
  Truth& truth = out.truth;
  const LoopSetup& setup = truth.setup;
  truth.signal_std = signal_std(setup, truth.trace);
  truth.noise_std = setup.noise_std;
  truth.excited = key.excitation != Excitation::kQuiet && !key.beyond_reach;
  truth.effects.clear();
  if (!sensible(setup, truth.trace, scale) ||
      (key.excitation != Excitation::kQuiet && !has_ratio(key, setup, truth.trace)) ||
      (key.excitation == Excitation::kLimitCycle &&
       !cycles_by_itself(setup, truth.trace))) {
    return false;
  }
  for (const Effect effect : key.effects) {
    const double left = irreducible(setup, truth.trace, effect, key.effects);
    const EffectTruth one{effect, left / truth.signal_std,
                          events_of(effect, setup, truth.trace),
                          true_parameters(effect, setup)};
    const bool matters = one.size >= kSmallestSize && one.events >= kFewestEvents;
    const bool absent = left <= kMostWhenQuiet * setup.noise_std;
    if (truth.excited ? !matters : !absent) {
      return false;
    }
    truth.effects.push_back(one);
  }
  return true;
}

}  // namespace

std::string_view name_of(Excitation excitation) {
  switch (excitation) {
    case Excitation::kSetpointSteps:
      return "steps";
    case Excitation::kLimitCycle:
      return "cycle";
    case Excitation::kQuiet:
      return "quiet";
  }
  return "";
}

std::string describe(const CaseKey& key) {
  std::string text;
  for (const Effect effect : key.effects) {
    text += std::string(text.empty() ? "" : "+") + std::string(code_of(effect));
  }
  text = text.empty() ? "clean" : text;
  text += key.beyond_reach ? " beyond" : "";
  return text + " " + std::string(name_of(key.excitation)) + " " +
         std::to_string(std::lround(key.signal_to_noise)) + " seed " +
         std::to_string(key.seed);
}

HiddenCase make_case(const CaseKey& key) {
  constexpr int kMostAttempts = 200;
  HiddenCase out;
  for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
    Scale scale;
    out.truth.setup = draw_loop(key, attempt, scale);
    out.truth.trace = run_with_noise(key, scale, out.truth.setup);
    if (!accept(key, scale, out)) {
      continue;
    }
    const LoopSetup& setup = out.truth.setup;
    workbench::Recording& recording = out.recording;
    recording.name = "recording";
    recording.period_s = setup.period_s;
    recording.u = recorded(setup, out.truth.trace.u);
    recording.y = recorded(setup, out.truth.trace.y);
    recording.sp = recorded(setup, out.truth.trace.sp);
    for (std::size_t k = 0; k < recording.u.size(); ++k) {
      recording.t.push_back(setup.period_s * static_cast<double>(k));
    }
    recording.resampling.rows = recording.size();
    return out;
  }
  throw std::runtime_error(describe(key) + ": no draw of the effect matters");
}

}  // namespace hidden
