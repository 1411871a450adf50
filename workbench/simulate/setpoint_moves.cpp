#include "workbench/simulate/setpoint_moves.hpp"

#include <cmath>
#include <numbers>

#include "workbench/simulate/noise.hpp"

namespace workbench {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

}  // namespace

std::vector<double> step_moves(Random& random, std::size_t samples, double hold) {
  std::vector<double> signal;
  signal.reserve(samples);
  double level = 0;
  while (signal.size() < samples) {
    // A move must be seen: at least a quarter of the range.
    double next = random.uniform(-1, 1);
    while (std::abs(next - level) < 0.5) next = random.uniform(-1, 1);
    level = next;
    const auto length = static_cast<std::size_t>(1 + hold * random.uniform(0.5, 2));
    for (std::size_t t = 0; t < length && signal.size() < samples; ++t) {
      signal.push_back(level);
    }
  }
  return signal;
}

std::vector<double> ramp_moves(Random& random, std::size_t samples, double hold) {
  const std::vector<double> levels = step_moves(random, samples, hold);
  const double slope = 2 / (hold * random.uniform(0.3, 1.5));
  std::vector<double> signal(samples);
  double value = 0;
  for (std::size_t t = 0; t < samples; ++t) {
    const double gap = levels[t] - value;
    value += std::abs(gap) < slope ? gap : std::copysign(slope, gap);
    signal[t] = value;
  }
  return signal;
}

std::vector<double> smooth_moves(Random& random, std::size_t samples, double period) {
  constexpr int kParts = 4;
  std::vector<double> signal(samples, 0.0);
  for (int part = 0; part < kParts; ++part) {
    const double turn = kTurn / (period * random.log_uniform(0.5, 3));
    const double phase = random.uniform(0, kTurn);
    for (std::size_t t = 0; t < samples; ++t) {
      signal[t] += std::sin(turn * static_cast<double>(t) + phase) / kParts;
    }
  }
  return signal;
}

std::vector<double> draw_moves(Random& random, std::size_t samples, double scale) {
  switch (random.integer(0, 2)) {
    case 0:
      return step_moves(random, samples, scale);
    case 1:
      return ramp_moves(random, samples, scale);
    default:
      return smooth_moves(random, samples, scale);
  }
}

std::vector<double> sinusoid(Random& random, std::size_t samples, double period,
                             double irregularity) {
  std::vector<double> wander(samples, 0.0);
  if (irregularity > 0) {
    wander = coloured_noise(random, samples, 1 - 0.5 / period, irregularity);
  }
  std::vector<double> signal(samples);
  double phase = random.uniform(0, kTurn);
  for (std::size_t t = 0; t < samples; ++t) {
    signal[t] = std::sin(phase);
    phase += kTurn / period * (1 + wander[t]);
  }
  return signal;
}

}  // namespace workbench
