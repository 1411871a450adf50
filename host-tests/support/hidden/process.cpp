#include "support/hidden/process.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hidden {

HiddenProcess::HiddenProcess(const ProcessPhysics& physics, double dt_s)
    : physics_(physics),
      dt_(dt_s),
      pipe_(static_cast<std::size_t>(std::lround(physics.dead_time_s / dt_s))) {}

HiddenProcess::State HiddenProcess::slope(const State& z, double input) const {
  double outflow = z[0];
  if (physics_.head != 0) {
    // An empty tank has no outflow: the root ends at zero.
    const double root = std::sqrt(std::max(0.0, 1 + z[0] / physics_.head));
    outflow = 2 * physics_.head * (root - 1);
  }
  State s{};
  const double share = physics_.opposite_share;
  s[0] =
      ((1 + share) * input - (physics_.integrating ? 0 : outflow)) / physics_.first_lag_s;
  if (s[0] < 0) s[0] /= physics_.falling_over_rising;
  s[1] = physics_.second_lag_s > 0 ? (z[0] - z[1]) / physics_.second_lag_s : 0;
  s[2] = physics_.sensor_lag_s > 0 ? (output(z) - z[2]) / physics_.sensor_lag_s : 0;
  s[3] = (share * input - z[3]) / physics_.fast_lag_s;
  if (physics_.ring_period_s > 0) {
    const double w = 2 * std::numbers::pi / physics_.ring_period_s;
    s[4] = z[5];
    s[5] = w * (w * (z[last_lag()] - z[4]) - 2 * physics_.ring_damping * z[5]);
  }
  s[6] = (untailed(z) - z[6]) / physics_.tail_lag_s;
  return s;
}

void HiddenProcess::advance(double v, double load, double gain_factor) {
  double arriving = v;
  if (!pipe_.empty()) {
    std::swap(arriving, pipe_[pipe_at_]);
    pipe_at_ = (pipe_at_ + 1) % pipe_.size();
  }
  const double input = physics_.gain * (gain_factor * arriving + load);
  const auto ahead = [&](const State& k, double dt) {
    State z = state_;
    for (std::size_t i = 0; i < z.size(); ++i) {
      z[i] += dt * k[i];
    }
    return z;
  };
  const State k1 = slope(state_, input);
  const State k2 = slope(ahead(k1, dt_ / 2), input);
  const State k3 = slope(ahead(k2, dt_ / 2), input);
  const State k4 = slope(ahead(k3, dt_), input);
  for (std::size_t i = 0; i < state_.size(); ++i) {
    state_[i] += dt_ / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  }
  ran_dry_ = ran_dry_ || (physics_.head != 0 && state_[0] / physics_.head < -1);
  double& level = state_[last_lag()];
  const bool full = level > physics_.overflow;
  overflows_ += full && !full_ ? 1 : 0;
  full_ = full;
  level = std::min(level, physics_.overflow);
}

double HiddenProcess::untailed(const State& z) const {
  return (physics_.ring_period_s > 0 ? z[4] : z[last_lag()]) - z[3];
}

double HiddenProcess::output(const State& z) const {
  const double most = untailed(z);
  return most + physics_.tail_share * (z[6] - most);
}

double HiddenProcess::sensed() const {
  return physics_.sensor_lag_s > 0 ? state_[2] : output(state_);
}

}  // namespace hidden
