// Simulated controller outputs with a known answer to "does it oscillate?".
// The detector's threshold is set on these and on labelled recordings alike.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

namespace oscillation_signals {

/// The same numbers on every platform: splitmix64 and Box-Muller.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(mixed(seed + 0x632BE59BD9B4E019u)) {}

  double uniform() {
    state_ += 0x9E3779B97F4A7C15u;
    return (static_cast<double>(mixed(state_) >> 11) + 0.5) * 0x1.0p-53;
  }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  double log_uniform(double low, double high) {
    return low * std::pow(high / low, uniform());
  }
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }
  bool chance(double probability) { return uniform() < probability; }

 private:
  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

struct Signal {
  std::string kind;
  bool oscillating = false;
  double period = 0;  ///< samples per cycle; 0: none
  std::vector<double> values;
};

enum class Shape { kSine, kTriangle, kSquare, kSawtooth, kRectified };

inline double shape_value(Shape shape, double phase, double skew) {
  constexpr double kPi = std::numbers::pi;
  switch (shape) {
    case Shape::kSine:
      return std::sin(2.0 * kPi * phase);
    case Shape::kTriangle:
      return 1.0 - 4.0 * std::fabs(phase - 0.5);
    case Shape::kSquare:
      return phase < skew ? 1.0 : -1.0;
    case Shape::kSawtooth:
      return phase < skew ? 2.0 * phase / skew - 1.0
                          : 1.0 - 2.0 * (phase - skew) / (1.0 - skew);
    case Shape::kRectified:
      return 2.0 * std::max(0.0, std::sin(2.0 * kPi * phase)) - 0.6;
  }
  return 0.0;
}

/// Adds what every plant adds: measurement noise, a wandering mean, now and
/// then steps, spikes or the resolution of the recorded value. `scale` is the
/// size of what the signal is about.
inline void add_surroundings(std::vector<double>& x, Random& random, double scale,
                             double wander_per_record) {
  const std::size_t n = x.size();
  const double noise = scale * random.log_uniform(0.01, 0.6);
  const double step = wander_per_record * scale / std::sqrt(static_cast<double>(n));
  const double slope =
      scale * random.normal() * wander_per_record / static_cast<double>(n);
  double wander = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    wander += step * random.normal();
    x[i] += noise * random.normal() + wander + slope * static_cast<double>(i);
  }
  if (random.chance(0.25)) {
    const int steps = 1 + static_cast<int>(random.uniform() * 3);
    for (int s = 0; s < steps; ++s) {
      const auto at = static_cast<std::size_t>(random.uniform() * static_cast<double>(n));
      const double size = scale * 2.0 * random.normal();
      for (std::size_t i = at; i < n; ++i) x[i] += size;
    }
  }
  if (random.chance(0.15)) {
    const int spikes = 1 + static_cast<int>(random.uniform() * 5);
    for (int s = 0; s < spikes; ++s) {
      const auto at = static_cast<std::size_t>(random.uniform() * static_cast<double>(n));
      x[at] += scale * 5.0 * random.normal();
    }
  }
  if (random.chance(0.2)) {
    const double quantum = scale * random.log_uniform(0.02, 0.3);
    for (double& v : x) v = quantum * std::round(v / quantum);
  }
}

/// A limit cycle drawn half by half: each half has its own length and height.
/// Sometimes it pauses, for a third of the record at most.
inline Signal drawn_cycle(Random& random) {
  Signal out;
  out.kind = "drawn cycle";
  out.oscillating = true;
  out.period = random.log_uniform(5.0, 320.0);
  const double cycles = random.log_uniform(3.5, 120.0);
  const auto n =
      static_cast<std::size_t>(std::clamp(cycles * out.period, 200.0, 20000.0));
  const auto shape = static_cast<Shape>(static_cast<int>(random.uniform() * 5));
  const double skew = random.uniform(0.3, 0.7);
  const double jitter = random.chance(0.4) ? 0.0 : random.uniform(0.0, 0.2);
  const double height_jitter = random.chance(0.4) ? 0.0 : random.uniform(0.0, 0.3);
  const double active = random.chance(0.75) ? 1.0 : random.uniform(0.65, 1.0);
  const double start = random.uniform(0.0, 1.0 - active + 1e-9);
  double phase = random.uniform();
  double length = out.period;
  double height = 1.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double where = static_cast<double>(i) / static_cast<double>(n);
    const bool on = where >= start && where < start + active;
    out.values.push_back(on ? height * shape_value(shape, phase, skew) : 0.0);
    const bool first_half = phase < 0.5;
    phase += 1.0 / length;
    const bool next_half = (first_half && phase >= 0.5) || phase >= 1.0;
    if (phase >= 1.0) phase -= 1.0;
    if (next_half) {
      length = out.period * std::exp(jitter * random.normal());
      height = std::exp(height_jitter * random.normal());
    }
  }
  add_surroundings(
      out.values, random, 1.0,
      random.chance(0.3) ? random.uniform(0.0, 8.0) : random.uniform(0.0, 1.5));
  return out;
}

/// A PI loop around a first-order process with dead time; `stick_band` > 0
/// puts a valve with static friction in it, `wave` a sinusoidal load.
struct Loop {
  double time_constant = 20;
  double gain = 1.0;
  int dead_time = 3;
  double controller_gain = 1.0;
  double reset_time = 20;
  double stick_band = 0;
  double slip_jump = 0;
  double wave = 0;
  double wave_period = 50;
  double load_noise = 0;
  double load_pole = 0.95;
  double sensor_noise = 0;
  double step_rate = 0;  ///< chance of a load step per sample
};

inline std::vector<double> run_loop(const Loop& loop, std::size_t n, Random& random) {
  std::vector<double> valve(static_cast<std::size_t>(loop.dead_time) + 1, 0.0);
  std::vector<double> out;
  const double pole = std::exp(-1.0 / loop.time_constant);
  double y = 0.3, stem = 0.0, integral = 0.0, load = 0.0, level = 0.0;
  const std::size_t settle = 400 + static_cast<std::size_t>(loop.time_constant * 5);
  for (std::size_t i = 0; i < n + settle; ++i) {
    const double error = -(y + loop.sensor_noise * random.normal());
    integral += loop.controller_gain / loop.reset_time * error;
    const double u = loop.controller_gain * error + integral;
    if (loop.stick_band > 0.0) {
      const double push = u - stem;
      const double fs = 0.5 * (loop.stick_band + loop.slip_jump);
      const double fd = 0.5 * (loop.stick_band - loop.slip_jump);
      if (std::fabs(push) > fs) stem = u - (push > 0 ? fd : -fd);
    } else {
      stem = u;
    }
    valve[i % valve.size()] = stem;
    load = loop.load_pole * load + loop.load_noise * random.normal();
    if (random.chance(loop.step_rate)) level += random.normal();
    const double wave = loop.wave * std::sin(2.0 * std::numbers::pi *
                                             static_cast<double>(i) / loop.wave_period);
    const double delayed = valve[(i + 1) % valve.size()];
    y = pole * y + (1.0 - pole) * (loop.gain * delayed + load + level + wave);
    if (i >= settle) out.push_back(u);
  }
  return out;
}

inline double deviation(const std::vector<double>& x) {
  double mean = 0.0, square = 0.0;
  for (double v : x) mean += v;
  mean /= static_cast<double>(x.size());
  for (double v : x) square += (v - mean) * (v - mean);
  return std::sqrt(square / static_cast<double>(x.size()));
}

/// Mean period between upward crossings of the mean: for clean signals only.
inline double clean_period(const std::vector<double>& x) {
  double mean = 0.0;
  for (double v : x) mean += v;
  mean /= static_cast<double>(x.size());
  double first = -1.0, last = -1.0;
  int count = 0;
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (x[i - 1] < mean && x[i] >= mean) {
      if (first < 0)
        first = static_cast<double>(i);
      else
        ++count;
      last = static_cast<double>(i);
    }
  }
  return count > 0 ? (last - first) / count : 0.0;
}

/// Controller settings by the lambda rule; `tightness` 1 is sluggish and
/// stable, 3 is brisk.
inline Loop tuned_loop(Random& random, double tightness) {
  Loop loop;
  loop.time_constant = random.log_uniform(3.0, 100.0);
  loop.dead_time = 1 + static_cast<int>(loop.time_constant * random.uniform(0.05, 0.6));
  loop.gain = random.uniform(0.5, 2.0);
  const double lambda = static_cast<double>(loop.dead_time) * 3.0 / tightness;
  loop.controller_gain =
      loop.time_constant / (loop.gain * (lambda + static_cast<double>(loop.dead_time)));
  loop.reset_time = loop.time_constant;
  return loop;
}

inline Signal sticking_loop(Random& random) {
  Signal out;
  out.kind = "sticking valve";
  out.oscillating = true;
  for (;;) {
    Loop loop = tuned_loop(random, random.uniform(1.0, 3.0));
    loop.stick_band = 1.0;
    loop.slip_jump = random.uniform(0.1, 1.0);
    Random quiet(1);
    const std::vector<double> clean = run_loop(loop, 6000, quiet);
    const double swing = deviation(clean);
    out.period = clean_period(clean);
    if (swing < 0.1 || out.period < 5.0 || out.period > 400.0) continue;
    loop.load_noise = random.log_uniform(0.001, 0.05);
    loop.load_pole = random.uniform(0.8, 0.99);
    loop.sensor_noise = random.log_uniform(0.001, 0.1) / (1.0 + loop.controller_gain);
    loop.step_rate = random.chance(0.3) ? 1.0 / (20.0 * out.period) : 0.0;
    const auto n = static_cast<std::size_t>(
        std::clamp(random.log_uniform(4.0, 100.0) * out.period, 200.0, 20000.0));
    out.values = run_loop(loop, n, random);
    // A valve may come to rest where it happens to fit: that is no oscillation.
    if (deviation(out.values) < 0.5 * swing) continue;
    return out;
  }
}

inline Signal waved_loop(Random& random) {
  Signal out;
  out.kind = "periodic load";
  out.oscillating = true;
  Loop loop = tuned_loop(random, random.uniform(0.7, 2.5));
  out.period = loop.time_constant * random.log_uniform(1.5, 10.0);
  out.period = std::clamp(out.period, 5.0, 320.0);
  loop.wave = 1.0;
  loop.wave_period = out.period;
  Random quiet(1);
  const double swing = deviation(run_loop(loop, 4000, quiet));
  const auto n = static_cast<std::size_t>(
      std::clamp(random.log_uniform(4.0, 100.0) * out.period, 200.0, 20000.0));
  out.values = run_loop(loop, n, random);
  add_surroundings(out.values, random, swing, random.uniform(0.0, 3.0));
  return out;
}

inline Signal healthy_loop(Random& random) {
  Signal out;
  out.kind = "healthy loop";
  Loop loop = tuned_loop(random, random.uniform(0.5, 2.2));
  const double what = random.uniform();
  if (what < 0.7) {
    loop.load_noise = 0.1;
    loop.load_pole = random.chance(0.3) ? 1.0 : random.uniform(0.5, 0.995);
  }
  if (what > 0.5) loop.step_rate = 1.0 / random.log_uniform(100.0, 3000.0);
  loop.sensor_noise = random.chance(0.5) ? 0.0 : random.log_uniform(0.005, 0.1);
  const auto n = static_cast<std::size_t>(random.log_uniform(250.0, 20000.0));
  out.values = run_loop(loop, n, random);
  const double swing = deviation(out.values) + 1e-9;
  if (random.chance(0.5)) {
    add_surroundings(out.values, random, swing, random.uniform(0.0, 2.0));
  }
  return out;
}

/// Noise of one or two poles. A pole pair is damped with at least 0.15, that
/// is, a wave has lost more than 60 % of its height when the next one comes.
inline Signal filtered_noise(Random& random) {
  Signal out;
  const auto n = static_cast<std::size_t>(random.log_uniform(250.0, 20000.0));
  const double what = random.uniform();
  double state = 0.0, before = 0.0;
  out.values.reserve(n);
  if (what < 0.15) {
    out.kind = "white noise";
    for (std::size_t i = 0; i < n; ++i) out.values.push_back(random.normal());
  } else if (what < 0.35) {
    out.kind = "one-pole noise";
    const double pole = 1.0 - random.log_uniform(0.003, 0.5);
    for (std::size_t i = 0; i < n; ++i) {
      state = pole * state + random.normal();
      out.values.push_back(state);
    }
  } else if (what < 0.55) {
    out.kind = "random walk";
    for (std::size_t i = 0; i < n; ++i) {
      state += random.normal();
      out.values.push_back(state);
    }
  } else {
    out.kind = "damped resonance";
    const double period = random.log_uniform(5.0, 200.0);
    const double damping = random.uniform(0.15, 0.6);
    const double natural =
        2.0 * std::numbers::pi / period / std::sqrt(1 - damping * damping);
    const double radius = std::exp(-damping * natural);
    const double a1 = 2.0 * radius * std::cos(2.0 * std::numbers::pi / period);
    const double a2 = -radius * radius;
    for (std::size_t i = 0; i < n + 500; ++i) {
      const double next = a1 * state + a2 * before + random.normal();
      before = state;
      state = next;
      if (i >= 500) out.values.push_back(state);
    }
  }
  const double swing = deviation(out.values) + 1e-9;
  if (random.chance(0.5)) {
    add_surroundings(out.values, random, swing, random.uniform(0.0, 3.0));
  }
  return out;
}

/// Staircases, single pulses, short bursts, a constant: no lasting cycle.
inline Signal no_cycle(Random& random) {
  Signal out;
  const auto n = static_cast<std::size_t>(random.log_uniform(250.0, 20000.0));
  out.values.assign(n, random.uniform(-50.0, 50.0));
  const double what = random.uniform();
  if (what < 0.1) {
    out.kind = "constant";
    return out;
  }
  if (what < 0.4) {
    out.kind = "staircase";
    const double rate = 1.0 / random.log_uniform(20.0, 500.0);
    const double trend = random.uniform(0.0, 1.5);
    double level = out.values[0];
    for (double& v : out.values) {
      if (random.chance(rate)) level += random.normal() + trend;
      v = level;
    }
    return out;
  }
  if (what < 0.7) {
    out.kind = "pulses";
    const double rate = 1.0 / random.log_uniform(100.0, 2000.0);
    const double decay = 1.0 - 1.0 / random.log_uniform(2.0, 100.0);
    double pulse = 0.0;
    for (double& v : out.values) {
      if (random.chance(rate)) pulse += random.normal();
      pulse *= decay;
      v += pulse;
    }
    add_surroundings(out.values, random, 0.3, random.uniform(0.0, 2.0));
    return out;
  }
  out.kind = "short burst";
  const double period = random.log_uniform(5.0, static_cast<double>(n) / 12.0);
  const double length = random.uniform(0.05, 0.25) * static_cast<double>(n);
  const double start = random.uniform(0.0, static_cast<double>(n) - length);
  for (std::size_t i = 0; i < n; ++i) {
    const double t = static_cast<double>(i) - start;
    if (t >= 0 && t < length)
      out.values[i] += std::sin(2.0 * std::numbers::pi * t / period);
  }
  add_surroundings(out.values, random, 0.7, random.uniform(0.0, 2.0));
  return out;
}

/// `count` signals, half of them oscillating; the same for the same seed.
inline std::vector<Signal> simulated_set(std::size_t count, std::uint64_t seed) {
  std::vector<Signal> set;
  for (std::size_t i = 0; i < count; ++i) {
    Random random(seed * 1000003u + i);
    switch (i % 8) {
      case 0:
      case 1:
        set.push_back(drawn_cycle(random));
        break;
      case 2:
        set.push_back(sticking_loop(random));
        break;
      case 3:
        set.push_back(waved_loop(random));
        break;
      case 4:
      case 5:
        set.push_back(filtered_noise(random));
        break;
      case 6:
        set.push_back(healthy_loop(random));
        break;
      default:
        set.push_back(no_cycle(random));
        break;
    }
  }
  return set;
}

}  // namespace oscillation_signals
