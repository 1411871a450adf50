// The process of the hidden-effect loops, in continuous time and in deviations from its
// point of rest: dead time, first lag (or integrator, or a draining tank), second lag,
// overflow, sensor lag. Integrated with the classical Runge-Kutta method.
//
//   self-regulating   first_lag·dz/dt = −ψ(z) + gain·(1 + drift(t))·v(t − dead_time) +
//   gain·load integrating       first_lag·dz/dt =         the same input ψ(z) = 2H·(√(1 +
//   z/H) − 1): outflow by gravity from a tank with head H at the point of rest (H < 0:
//   the mirror image); ψ(z) = z for H = 0. ψ'(0) = 1.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "support/hidden/valve.hpp"

namespace hidden {

/// y in its own units, the input in units of u, time in seconds.
struct ProcessPhysics {
  double gain = 1;
  double first_lag_s = 1;
  double second_lag_s = 0;
  double dead_time_s = 0;
  bool integrating = false;
  double head = 0;        ///< H; 0 for a constant gain
  double gain_drift = 0;  ///< gain·(1 + gain_drift·(share of the recording − ½))
  double overflow = kUnlimited;  ///< the last lag does not rise above this deviation
  double sensor_lag_s = 0;
  /// A second path straight from the input to y, of opposite sign: y = (1 + share) times
  /// what the lags make of it less share times what the fast lag does.
  double opposite_share = 0;
  double fast_lag_s = 1;
  double ring_period_s = 0;  ///< of a pair of storages behind the lags; 0 for none
  double ring_damping = 1;
  double falling_over_rising = 1;  ///< first lag while its content falls
  /// Of what the lags give, this share comes through one more lag, beside the rest.
  double tail_share = 0;
  double tail_lag_s = 1;
};

class HiddenProcess {
 public:
  HiddenProcess(const ProcessPhysics& physics, double dt_s);

  /// Holds the flow deviation `v` and the load for one dt_s; `gain_factor` is the drift.
  void advance(double v, double load, double gain_factor);

  /// Deviation that the sensor reports, without noise.
  [[nodiscard]] double sensed() const;
  [[nodiscard]] int overflows() const { return overflows_; }
  /// The tank was drawn below its bottom, where ψ stays −2H: no tank does that.
  [[nodiscard]] bool ran_dry() const { return ran_dry_; }

 private:
  // First lag, second lag, sensor lag, opposite path, ringing pair and its slope, tail.
  using State = std::array<double, 7>;
  [[nodiscard]] State slope(const State& z, double input) const;
  [[nodiscard]] double untailed(const State& z) const;
  [[nodiscard]] double output(const State& z) const;
  [[nodiscard]] std::size_t last_lag() const { return physics_.second_lag_s > 0 ? 1 : 0; }

  ProcessPhysics physics_;
  double dt_;
  State state_{};
  std::vector<double> pipe_;  // ring buffer of the dead time
  std::size_t pipe_at_ = 0;
  int overflows_ = 0;
  bool full_ = false;
  bool ran_dry_ = false;
};

}  // namespace hidden
