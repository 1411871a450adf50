// A process with two poles behind a given valve, and its output in pieces.
#pragma once

#include <array>
#include <cstddef>
#include <numeric>
#include <span>

#include "ident/process/start_column.hpp"

namespace ident {

/// The nonlinear part of the process: two real poles in 0 … 1, per sample of the data
/// that it is fitted to. pole 0: none; slow_pole 1: integrating.
template <class Real>
struct ProcessPoles {
  Real slow = 0;
  Real fast = 0;

  [[nodiscard]] bool operator==(const ProcessPoles&) const = default;
};

/// y(t) = gain_a·z(t − delay) + gain_b·z(t − delay − 1) + offset + drift·t + start, where
/// z is x less PoleFilter::origin through the poles with unit steady gain; when
/// integrating, the running sum of x less its mean, scaled by 16 / N.
template <class Real>
struct ProcessFit {
  Real error = 0;       ///< Σ(y − ŷ)² over the samples
  int delay = 0;        ///< samples
  Real gain_a = 0;      ///< ≥ 0: steady gain times the share of the first tap
  Real gain_b = 0;      ///< ≥ 0: fractional dead time between two taps
  Real offset = 0;      ///< at mid-window
  Real drift = 0;       ///< change from mid-window to its end
  Real start_slow = 0;  ///< weight of what the slow pole remembered at the start
  Real start_fast = 0;  ///< the same for the fast pole
  bool drifts = false;  ///< a drift was allowed; the start columns are then free of one
};

/// Longest dead time that is tried, in samples.
inline constexpr int kDelayTaps = 16;

/// Longest time before the window that a tap reaches into.
inline constexpr int kSamplesBefore = kDelayTaps + 1;

/// Of the input of both poles, one after the other, so that their steady gain is 1. An
/// integrator's is scaled so that a ramp over the `samples` of a window is of order one.
template <class Real>
[[nodiscard]] Real unit_gain(const ProcessPoles<Real>& poles, Real samples) {
  return poles.slow < Real(1) ? (Real(1) - poles.slow) * (Real(1) - poles.fast)
                              : (Real(1) - poles.fast) * Real(16) / samples;
}

/// x through both poles. Before the window the stem stood at x(0); what that leaves is
/// counted as far as an offset and the start columns of a fit cannot take it up.
///
/// A short memory is counted from x(0): z begins in its steady state, and all is 0
/// before. A memory of much of the window would be a ramp then, beside which nothing else
/// shows in single precision: it is counted from the mean of x, without that ramp, and
/// the same ramp is missing before the window.
template <class Real>
class PoleFilter {
 public:
  PoleFilter() = default;
  /// x: ≥ 1 samples. Cost: one pass if z is counted from the mean.
  PoleFilter(const ProcessPoles<Real>& poles, std::span<const Real> x)
      : slow_(poles.slow), fast_(poles.fast), origin_(x[0]) {
    const Real count = static_cast<Real>(x.size());
    gain_ = unit_gain(poles, count);
    if (slow_ > Real(kLeastRemembering) &&
        !((Real(1) - slow_) * count > Real(kRemembered))) {
      origin_ = std::accumulate(x.begin(), x.end(), Real(0)) / count;
      step_before_ = x[0] - origin_;
      fast_state_ = follows() ? following(Real(0)) : Real(0);
    }
  }
  /// The stem position that is counted from.
  [[nodiscard]] Real origin() const { return origin_; }
  /// Whether z is not 0 throughout before the window.
  [[nodiscard]] bool moved_before() const { return step_before_ != Real(0); }
  /// z(−1), z(−2) …; before the first step.
  [[nodiscard]] std::array<Real, kSamplesBefore> before() const {
    std::array<Real, kSamplesBefore> z{};
    if (!moved_before()) {
      return z;
    }
    Real slow = 0;
    Real fast = fast_state_;
    for (Real& value : z) {
      value = gain_ * fast;
      const Real earlier = (slow - step_before_) / slow_;
      fast = follows() ? following(earlier) : (fast - slow) / fast_;
      slow = earlier;
    }
    return z;
  }
  /// The next sample of z.
  Real step(Real x) {
    slow_state_ = slow_ * slow_state_ + (x - origin_);
    fast_state_ = fast_ * fast_state_ + slow_state_;
    return gain_ * fast_state_;
  }

 private:
  // Time constants of a window, and the least pole, that are counted from the mean.
  static constexpr double kRemembered = 8;
  static constexpr double kLeastRemembering = 0.85;

  // Whether the fast pole has forgotten all but what the slow one did of late. If not,
  // its own start is left to its column.
  [[nodiscard]] bool follows() const {
    return fast_ < Real(0.9) && Real(2) * (Real(1) - slow_) < Real(1) - fast_;
  }
  [[nodiscard]] Real following(Real slow) const {
    return (slow_ * slow - fast_ / (Real(1) - fast_) * step_before_) / (slow_ - fast_);
  }

  Real slow_ = 0;
  Real fast_ = 0;
  Real origin_ = 0;
  Real step_before_ = 0;
  Real gain_ = 0;
  Real slow_state_ = 0;
  Real fast_state_ = 0;
};

/// A fast pole of 0 is no pole and remembers nothing; no column, like an integrator's.
template <class Real>
[[nodiscard]] Real start_pole(Real fast) {
  return fast > Real(0) ? fast : Real(1);
}

/// ŷ of a fit: start → step until done. Fixed memory, about 60 numbers.
template <class Real>
class ProcessSimulation {
 public:
  /// x, y: equal lengths ≥ 1; they may be the same memory and must outlive the work.
  void start(std::span<const Real> x, const ProcessPoles<Real>& poles,
             const ProcessFit<Real>& fit, std::span<Real> y);
  /// At most `samples` ≥ 1 samples more; true when done.
  bool step(std::size_t samples);
  /// What one sample takes, instructions of a Cortex-M4F.
  [[nodiscard]] int cost_of_sample() const { return 150 + 8 * fit_.delay; }
  /// Samples that are there.
  [[nodiscard]] std::size_t simulated() const { return next_; }

 private:
  std::span<const Real> x_;
  std::span<Real> y_;
  ProcessFit<Real> fit_;
  PoleFilter<Real> filter_;
  StartColumn<Real> slow_start_;
  StartColumn<Real> fast_start_;
  std::array<Real, kSamplesBefore> lags_{};
  std::size_t next_ = 0;
};

}  // namespace ident
