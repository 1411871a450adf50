#include "clocked_loops.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace score {
namespace {

constexpr std::size_t kUnequalSteps = 1;
constexpr std::array kJitters = {0.0, 0.02, 0.05};

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }
  double log_uniform(double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
  }
  double normal() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += uniform(0, 1);
    return sum;
  }
  template <class Values>
  auto one_of(const Values& values) {
    return values[static_cast<std::size_t>(random_() % std::size(values))];
  }

 private:
  std::mt19937_64 random_;
};

// A load of that shape at a phase from 0 to 1; `duty`: of unequal steps. −1 … 1.
double load_at(std::size_t shape, double phase, double duty) {
  const double ramps = phase < 0.5 ? 4 * phase - 1 : 3 - 4 * phase;
  const double lags =
      phase < 0.5 ? 1 - 2 * std::exp(-8 * phase) : 2 * std::exp(-8 * (phase - 0.5)) - 1;
  constexpr double kTurn = 6.283185307179586;
  switch (shape) {
    case 0:
      return phase < 0.5 ? 1 : -1;
    case 1:
      return phase < duty ? 1 : -1;
    case 2:
      return std::floor(4 * phase) / 1.5 - 1;
    case 3:
      return ramps;
    case 4:
      return 2 * phase - 1;
    case 5:
      return std::clamp(2 * ramps, -1.0, 1.0);
    case 6:
      return lags;
    default:
      return std::sin(kTurn * phase) + 0.3 * std::sin(2 * kTurn * phase);
  }
}

}  // namespace

ClockedLoop clocked_loop(std::uint64_t seed, Times times) {
  Draw draw(seed);
  ClockedLoop out;
  out.shape = times == Times::kAny ? kUnequalSteps : seed % kShapes.size();
  out.jitter = kJitters[seed / kShapes.size() % kJitters.size()];
  const auto samples = static_cast<std::size_t>(draw.uniform(700, 2200));
  const double lag = draw.log_uniform(3, 60);
  const double second = lag * draw.one_of(std::array{0.0, 0.2, 0.5});
  const auto dead = draw.one_of(std::array<std::size_t, 5>{0, 1, 2, 5, 10});
  const bool integrating = draw.uniform(0, 1) < 0.25;
  const double gain = draw.one_of(std::array{0.5, 1.0, 2.0});
  const double period = draw.log_uniform(40, 220);
  const double closed =
      std::max(lag, static_cast<double>(dead)) * draw.log_uniform(0.4, 2);
  const double answer = closed + static_cast<double>(dead);
  const double proportional = lag / (gain * answer);
  const double reset = integrating ? 4 * answer : std::min(lag, 4 * answer);
  const double size = draw.one_of(std::array{2.0, 5.0, 10.0});
  const double noise = size * draw.one_of(std::array{0.0, 0.01, 0.03, 0.1});
  const bool before = draw.uniform(0, 1) < 0.5;
  double duty = draw.uniform(0.25, 0.75);
  const auto every = draw.one_of(std::array<std::size_t, 4>{1, 1, 2, 3});
  out.every = every;
  out.recording.name = "loop.csv";
  out.recording.period_s = static_cast<double>(every);
  std::vector<double> pipe(dead + 1, 0.0);
  double phase = 0;
  double length = period;
  double first = 0;
  double y = 0;
  double behind = 0;
  double sum = 0;
  for (std::size_t k = 0; k < samples; ++k) {
    phase += 1 / length;
    if (phase >= 1) {
      phase -= 1;
      length = period * std::max(0.2, 1 + out.jitter * draw.normal());
      if (times == Times::kAny) {
        length = period * draw.uniform(0.5, 3);
        duty = draw.uniform(0.2, 0.8);
      }
    }
    const double load = size * load_at(out.shape, phase, duty);
    const double valve = pipe[k % pipe.size()] + (before ? load / gain : 0);
    const double share = 1 - std::exp(-1 / lag);
    first += integrating ? gain * valve / lag : (gain * valve - first) * share;
    y += second > 0 ? (first - y) * (1 - std::exp(-1 / second)) : first - y;
    behind += (load - behind) * (1 - std::exp(-1 / std::max(0.3 * lag, 1.0)));
    const double measured = y + (before ? 0 : behind) + noise * draw.normal();
    sum -= proportional / reset * measured;
    const double u = std::clamp(sum - proportional * measured, -1e4, 1e4);
    pipe[k % pipe.size()] = u;
    if (k % every != 0) continue;
    out.recording.t.push_back(static_cast<double>(k));
    out.recording.u.push_back(50 + u);
    out.recording.y.push_back(100 + measured);
    out.recording.sp.push_back(100);
  }
  return out;
}

}  // namespace score
