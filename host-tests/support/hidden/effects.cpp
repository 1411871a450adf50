#include "support/hidden/effects.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hidden {
namespace {

constexpr std::array<std::string_view, kEffects> kCodes{
    "valve.stiction",          "valve.backlash",
    "valve.saturation",        "valve.characteristic",
    "valve.positioner_lag",    "valve.rate_limit",
    "process.dead_time",       "process.second_lag",
    "process.integrating",     "process.nonlinear_gain",
    "process.gain_drift",      "process.overflow",
    "disturbance.sinusoid",    "disturbance.step",
    "disturbance.ramp",        "sensor.lag",
    "sensor.quantisation",     "process.inverse_response",
    "process.oscillatory",     "sensor.sticking",
    "sensor.spikes",           "record.compression",
    "process.directional_lag", "process.slow_tail",
    "sensor.saturation"};

/// Stick band S and slip jump J of one stroke: S = static + kinetic of the other stroke.
void draw_stiction(const Scale& scale, Random& random, const LoopSetup& setup,
                   ValvePhysics& valve) {
  const double band = scale.swing_u * random.uniform(0.35, 1.0);
  const double jump_share = random.uniform(0.25, 0.8);
  const double fixed = band * (1 + jump_share) / 2;
  const double moving = band * (1 - jump_share) / 2;
  valve.static_ascending = valve.static_descending = fixed;
  valve.kinetic_ascending = valve.kinetic_descending = moving;
  const double kind = random.uniform();
  if (kind < 0.25) {  // the descending stroke sticks less
    const double share = random.uniform(0.4, 0.8);
    valve.static_descending *= share;
    valve.kinetic_descending *= share;
  } else if (kind < 0.4) {  // only one stroke sticks
    valve.static_descending = valve.kinetic_descending = 0;
  }
  if (kind < 0.4 && random.chance(0.5)) {
    std::swap(valve.static_ascending, valve.static_descending);
    std::swap(valve.kinetic_ascending, valve.kinetic_descending);
  }
  valve.slide_s = setup.period_s * random.uniform(0.02, 0.12);
  valve.keeps_sliding = random.chance(0.5);
}

void draw_spikes(const Scale& scale, Random& random, LoopSetup& setup) {
  const std::size_t n = setup.warm_up + setup.samples;
  setup.spikes.assign(n, 0.0);
  const auto count = static_cast<int>(random.uniform(8, 25));
  const bool either_way = random.chance(0.5);
  const double sense = random.sign();
  for (int i = 0; i < count; ++i) {
    const auto at =
        setup.warm_up + static_cast<std::size_t>(random.uniform(0.01, 0.99) *
                                                 static_cast<double>(setup.samples));
    setup.spikes[at] =
        scale.swing_y * random.uniform(1.5, 4) * (either_way ? random.sign() : sense);
  }
}

struct Range {
  double low = 0;
  double high = 0;
  [[nodiscard]] double at(double share) const { return low + share * (high - low); }
};

/// The range that holds all but 2 % of the recorded samples at either end.
Range range_of(const LoopSetup& setup, const std::vector<double>& signal) {
  std::vector<double> sorted = recorded(setup, signal);
  std::sort(sorted.begin(), sorted.end());
  return {sorted[sorted.size() / 50], sorted[sorted.size() - 1 - sorted.size() / 50]};
}

void draw_saturation(const Trace& trace, bool reached, Random& random, LoopSetup& setup) {
  const Range range = range_of(setup, trace.stem);
  const double kind = random.uniform();
  const double cut = reached ? random.uniform(0.15, 0.4) : random.uniform(-0.9, -0.5);
  const double other = reached ? random.uniform(0.15, 0.4) : random.uniform(-0.9, -0.5);
  if (kind < 0.7) {
    setup.valve.travel_high = range.at(1 - cut);
  }
  if (kind > 0.4) {
    setup.valve.travel_low = range.at(other);
  }
  if (!reached) {
    // Beyond the two percent at either end as well.
    const auto [least, most] = std::minmax_element(trace.u.begin(), trace.u.end());
    setup.valve.travel_high = std::max(setup.valve.travel_high, *most + 1);
    setup.valve.travel_low = std::min(setup.valve.travel_low, *least - 1);
  }
}

void draw_rate_limit(const Trace& trace, bool reached, Random& random, LoopSetup& setup) {
  std::vector<double> moves;
  const std::vector<double> u = recorded(setup, trace.u);
  for (std::size_t k = 1; k < u.size(); ++k) {
    moves.push_back(std::abs(u[k] - u[k - 1]));
  }
  std::sort(moves.begin(), moves.end());
  if (!reached) {
    // So fast that every move is over within the first sub-step.
    const double fast = 2 * moves.back() * setup.sub_steps / setup.period_s;
    setup.valve.opening_rate = setup.valve.closing_rate = fast;
    return;
  }
  const double large = moves[moves.size() - kFewestEvents];
  const double rate = large / (setup.process.first_lag_s * random.uniform(0.3, 1.2));
  const double kind = random.uniform();
  setup.valve.opening_rate = kind < 0.25 ? kUnlimited : rate;
  setup.valve.closing_rate =
      kind >= 0.25 && kind < 0.5 ? kUnlimited : rate * random.uniform(0.6, 1.6);
}

void draw_overflow(const Trace& trace, bool reached, Random& random, LoopSetup& setup) {
  const std::vector<double> sensed = recorded(setup, trace.sensed);
  const double most = *std::max_element(sensed.begin(), sensed.end()) - setup.rest_y;
  const double least = *std::min_element(sensed.begin(), sensed.end()) - setup.rest_y;
  if (!reached) {
    setup.process.overflow = most + random.uniform(0.3, 0.8) * (most - least);
  } else if (setup.controller.kind == ControllerKind::kPi) {
    setup.process.overflow = least + random.uniform(0.6, 0.9) * (most - least);
  } else {
    // Above the point where the controller turns round, or the loop would stop there.
    const double turn = setup.setpoint.back() + setup.controller.hysteresis;
    setup.process.overflow = turn + random.uniform(0.1, 0.6) * (most - turn);
  }
}

void draw_range(const Trace& trace, bool reached, Random& random, LoopSetup& setup) {
  const std::vector<double> sensed = recorded(setup, trace.sensed);
  const auto [least, most] = std::minmax_element(sensed.begin(), sensed.end());
  const bool upper = random.chance(0.5);
  const double far = upper ? *most : *least;
  const double near = upper ? *least : *most;
  double end = far + random.uniform(0.3, 0.8) * (far - near);
  if (reached && setup.controller.kind == ControllerKind::kPi) {
    end = near + random.uniform(0.6, 0.9) * (far - near);
  } else if (reached) {
    // Beyond the point where the controller turns round, or the loop would stop there.
    const auto [lowest, highest] =
        std::minmax_element(setup.setpoint.begin(), setup.setpoint.end());
    const double turn = setup.rest_y + (upper ? *highest + setup.controller.hysteresis
                                              : *lowest - setup.controller.hysteresis);
    end = turn + random.uniform(0.1, 0.6) * (far - turn);
  }
  (upper ? setup.reading_high : setup.reading_low) = end;
}

double standard_deviation(const std::vector<double>& values) {
  double sum = 0;
  double squares = 0;
  for (const double v : values) {
    sum += v - values[0];
    squares += (v - values[0]) * (v - values[0]);
  }
  const auto n = static_cast<double>(values.size());
  return std::sqrt(std::max(0.0, squares / n - (sum / n) * (sum / n)));
}

}  // namespace

std::string_view code_of(Effect effect) {
  return kCodes[static_cast<std::size_t>(effect)];
}

std::array<Effect, kEffects> all_effects() {
  std::array<Effect, kEffects> all{};
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] = static_cast<Effect>(i);
  }
  return all;
}

bool is_limit(Effect effect) {
  return effect == Effect::kSaturation || effect == Effect::kRateLimit ||
         effect == Effect::kOverflow || effect == Effect::kQuantisation ||
         effect == Effect::kReadingEnd;
}

bool is_recorded(Effect effect) {
  return effect == Effect::kSticking || effect == Effect::kSpikes ||
         effect == Effect::kCompression || effect == Effect::kQuantisation ||
         effect == Effect::kReadingEnd;
}

void draw_effect(Effect effect, const Scale& scale, Random& random, LoopSetup& setup) {
  const double load = scale.narrow ? 0.5 * scale.swing_u : scale.swing_u;
  const double duration = setup.period_s * static_cast<double>(setup.samples);
  switch (effect) {
    case Effect::kStiction:
      draw_stiction(scale, random, setup, setup.valve);
      break;
    case Effect::kBacklash:
      setup.valve.backlash = scale.swing_u * random.uniform(0.4, 1.2);
      break;
    case Effect::kCharacteristic:
      setup.valve.characteristic =
          random.sign() * std::log(random.log_uniform(20, 100)) / 100;
      break;
    case Effect::kPositionerLag:
      setup.valve.positioner_lag_s = scale.lag_s * random.uniform(0.2, 0.7);
      break;
    case Effect::kDeadTime:
      setup.process.dead_time_s = scale.lag_s * random.uniform(0.2, 1.0);
      break;
    case Effect::kSecondLag:
      setup.process.second_lag_s = scale.lag_s * random.uniform(0.2, 0.8);
      break;
    case Effect::kIntegrating:
      setup.process.integrating = true;
      break;
    case Effect::kNonlinearGain:
      // A relay overshoots its setpoints by as much again as they move.
      setup.process.head = random.sign() * scale.swing_y * (scale.narrow ? 2 : 1) *
                           random.uniform(1.03, 1.4);
      break;
    case Effect::kGainDrift:
      setup.process.gain_drift = random.sign() * random.uniform(0.5, 1.2);
      break;
    case Effect::kSinusoid:
      setup.loads.sinusoid = load * random.uniform(0.3, 0.9);
      setup.loads.sinusoid_period_s = scale.lag_s * random.log_uniform(1.5, 8);
      setup.loads.sinusoid_phase = random.uniform(0, 2 * std::numbers::pi);
      break;
    case Effect::kStep:
      setup.loads.step = random.sign() * load * random.uniform(0.4, 1.2);
      setup.loads.step_at_s = duration * random.uniform(0.25, 0.75);
      break;
    case Effect::kRamp:
      setup.loads.ramp = random.sign() * load * random.uniform(0.6, 1.8);
      setup.loads.ramp_from_s =
          random.chance(0.4) ? duration * random.uniform(0.1, 0.5) : 0;
      break;
    case Effect::kSensorLag:
      setup.process.sensor_lag_s = scale.lag_s * random.uniform(0.15, 0.6);
      break;
    case Effect::kInverseResponse:
      setup.process.fast_lag_s = scale.lag_s * random.uniform(0.05, 0.35);
      setup.process.opposite_share = random.uniform(0.6, 1.2) * setup.process.fast_lag_s /
                                         (scale.lag_s - setup.process.fast_lag_s) +
                                     random.uniform(0.2, 0.8);
      break;
    case Effect::kOscillatory:
      setup.process.ring_period_s = scale.lag_s * random.uniform(1.5, 4);
      setup.process.ring_damping = random.log_uniform(0.1, 0.5);
      setup.process.first_lag_s *= random.uniform(0.1, 0.6);
      break;
    case Effect::kSticking:
      setup.sticking_band = scale.swing_y * random.uniform(0.2, 0.6);
      break;
    case Effect::kSpikes:
      draw_spikes(scale, random, setup);
      break;
    case Effect::kCompression:
      setup.compression = scale.swing_y * random.uniform(0.1, 0.3);
      setup.holds_stored = random.chance(0.3);
      break;
    case Effect::kDirectionalLag:
      setup.process.falling_over_rising =
          std::exp(random.sign() * std::log(random.uniform(1.4, 3)));
      break;
    case Effect::kSlowTail:
      setup.process.tail_share = random.uniform(0.2, 0.5);
      setup.process.tail_lag_s = scale.lag_s * random.log_uniform(3, 10);
      break;
    case Effect::kSaturation:
    case Effect::kRateLimit:
    case Effect::kOverflow:
    case Effect::kQuantisation:
    case Effect::kReadingEnd:
      break;  // draw_limit
  }
}

void draw_limit(Effect effect, const Trace& trace, bool reached, Random& random,
                LoopSetup& setup) {
  if (effect == Effect::kSaturation) {
    draw_saturation(trace, reached, random, setup);
  } else if (effect == Effect::kRateLimit) {
    draw_rate_limit(trace, reached, random, setup);
  } else if (effect == Effect::kOverflow) {
    draw_overflow(trace, reached, random, setup);
  } else if (effect == Effect::kReadingEnd) {
    draw_range(trace, reached, random, setup);
  } else if (effect == Effect::kQuantisation) {
    setup.quantum =
        random.uniform(0.3, 1.0) * standard_deviation(recorded(setup, trace.sensed));
  }
}

LoopSetup without(const LoopSetup& setup, Effect effect) {
  LoopSetup rest = setup;
  const ValvePhysics linear;
  switch (effect) {
    case Effect::kStiction:
      rest.valve.static_ascending = rest.valve.static_descending = 0;
      rest.valve.kinetic_ascending = rest.valve.kinetic_descending = 0;
      break;
    case Effect::kBacklash:
      rest.valve.backlash = 0;
      break;
    case Effect::kSaturation:
      rest.valve.travel_low = linear.travel_low;
      rest.valve.travel_high = linear.travel_high;
      break;
    case Effect::kCharacteristic:
      rest.valve.characteristic = 0;
      break;
    case Effect::kPositionerLag:
      rest.valve.positioner_lag_s = 0;
      break;
    case Effect::kRateLimit:
      rest.valve.opening_rate = rest.valve.closing_rate = kUnlimited;
      break;
    case Effect::kDeadTime:
      rest.process.dead_time_s = 0;
      break;
    case Effect::kSecondLag:
      rest.process.second_lag_s = 0;
      break;
    case Effect::kIntegrating:
      rest.process.integrating = false;
      break;
    case Effect::kNonlinearGain:
      rest.process.head = 0;
      break;
    case Effect::kGainDrift:
      rest.process.gain_drift = 0;
      break;
    case Effect::kOverflow:
      rest.process.overflow = kUnlimited;
      break;
    case Effect::kSinusoid:
      rest.loads.sinusoid = 0;
      break;
    case Effect::kStep:
      rest.loads.step = 0;
      break;
    case Effect::kRamp:
      rest.loads.ramp = 0;
      break;
    case Effect::kSensorLag:
      rest.process.sensor_lag_s = 0;
      break;
    case Effect::kQuantisation:
      rest.quantum = 0;
      break;
    case Effect::kInverseResponse:
      rest.process.opposite_share = 0;
      break;
    case Effect::kOscillatory:
      rest.process.ring_period_s = 0;
      break;
    case Effect::kSticking:
      rest.sticking_band = 0;
      break;
    case Effect::kSpikes:
      rest.spikes.clear();
      break;
    case Effect::kCompression:
      rest.compression = 0;
      break;
    case Effect::kDirectionalLag:
      rest.process.falling_over_rising = 1;
      break;
    case Effect::kSlowTail:
      rest.process.tail_share = 0;
      break;
    case Effect::kReadingEnd:
      rest.reading_low = -kUnlimited;
      rest.reading_high = kUnlimited;
      break;
  }
  return rest;
}

int events_of(Effect effect, const LoopSetup& setup, const Trace& trace) {
  switch (effect) {
    case Effect::kStiction:
    case Effect::kBacklash:
      return trace.valve.turns;
    case Effect::kSaturation:
      return trace.valve.limit_hits;
    case Effect::kRateLimit:
      return trace.rate_limited;
    case Effect::kOverflow:
      return trace.overflows;
    case Effect::kReadingEnd:
      return trace.cut_off;
    default:
      return static_cast<int>(setup.samples);
  }
}

std::vector<TrueParameter> true_parameters(Effect effect, const LoopSetup& setup) {
  std::vector<TrueParameter> all;
  const auto add = [&](const char* name, double value) {
    if (std::isfinite(value)) {
      all.push_back({name, value});
    }
  };
  const ValvePhysics& valve = setup.valve;
  const double sub_step_s = setup.period_s / setup.sub_steps;  // of the simulated pipe
  switch (effect) {
    case Effect::kStiction:
      add("stick_band_ascending", valve.static_ascending + valve.kinetic_descending);
      add("stick_band_descending", valve.static_descending + valve.kinetic_ascending);
      add("deadband", valve.kinetic_ascending + valve.kinetic_descending);
      add("slip_jump_ascending", valve.static_ascending - valve.kinetic_ascending);
      add("slip_jump_descending", valve.static_descending - valve.kinetic_descending);
      break;
    case Effect::kBacklash:
      add("deadband", valve.backlash);
      break;
    case Effect::kSaturation:
      add("lower_limit", valve.travel_low);
      add("upper_limit", valve.travel_high);
      break;
    case Effect::kRateLimit:
      add("opening_rate", valve.opening_rate);
      add("closing_rate", valve.closing_rate);
      break;
    case Effect::kDeadTime:
      add("dead_time", sub_step_s * std::round(setup.process.dead_time_s / sub_step_s));
      break;
    case Effect::kOverflow:
      add("level", setup.rest_y + setup.process.overflow);
      break;
    case Effect::kSinusoid:
      add("period", setup.loads.sinusoid_period_s);
      break;
    case Effect::kStep:
      add("time", setup.loads.step_at_s);
      add("amplitude", setup.process.gain * setup.loads.step);
      break;
    case Effect::kRamp:
      add("slope", setup.process.gain * setup.loads.ramp /
                       (setup.period_s * static_cast<double>(setup.samples) -
                        setup.loads.ramp_from_s));
      break;
    case Effect::kQuantisation:
      add("step", setup.quantum);
      break;
    case Effect::kOscillatory:
      add("period", setup.process.ring_period_s);
      add("damping", setup.process.ring_damping);
      break;
    case Effect::kSticking:
      add("band", setup.sticking_band);
      break;
    case Effect::kSpikes:
      add("readings", static_cast<double>(setup.spikes.size()) -
                          static_cast<double>(
                              std::count(setup.spikes.begin(), setup.spikes.end(), 0.0)));
      break;
    case Effect::kCompression:
      add("tolerance", setup.compression);
      break;
    case Effect::kSlowTail:
      add("tail_share", setup.process.tail_share);
      add("tail_lag", setup.process.tail_lag_s);
      break;
    case Effect::kReadingEnd:
      add("lower_end", setup.reading_low);
      add("upper_end", setup.reading_high);
      break;
    default:
      break;  // lags are interchangeable, the rest depends on the form of the model
  }
  return all;
}

}  // namespace hidden
