// Linear dynamics between valve and output: dead time, lags, integrator; sampled exactly
// for an input that is constant between samples.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "workbench/effects/curve.hpp"

namespace workbench {

/// The dynamics of a process with unit gain. Times in s, 0 = absent.
struct ProcessShape {
  double first_lag_s = 0;  ///< ignored where `integrating`
  double second_lag_s = 0;
  double dead_time_s = 0;
  double sensor_lag_s = 0;  ///< acts behind the loads and the overflow
  /// Content of each storage over its outflow: where it is steep, gain and lag are both
  /// large, as in a tank that empties by its own head. Straight: constant lags.
  Curve storage;
  bool last_only = false;  ///< of two storages only the last one is curved
  /// Inflow that just holds the first of two storages full: of what it cannot hold,
  /// `spill_share` reaches the second at once, and the rest is lost.
  double brim = std::numeric_limits<double>::infinity();
  double spill_share = 1;
  /// A fast part of opposite sign behind a lag of `fast_lag_s`: the response goes the
  /// wrong way first, by the factor (1 − opposite_s·s)/(1 + fast_lag_s·s).
  double opposite_s = 0;
  double fast_lag_s = 0;
  /// A further pair of storages that hand on to each other and ring: natural period and
  /// damping, 1 where they just do not; 0: absent.
  double ring_period_s = 0;
  double ring_damping = 1;
  /// First lag while its content falls, over the lag while it rises.
  double falling_over_rising = 1;
  /// Of the answer: comes with another lag behind the rest; 0: none.
  double tail_share = 0;
  double tail_lag_s = 0;
  double start = 0;          ///< content of the storages at first, less the first input
  bool integrating = false;  ///< ∫ v dt in s times units of v, instead of the first lag
};

/// First-order lag with unit gain. out[0] = `start`; in[k] acts from sample k to k + 1.
/// `in` and `out` may be the same. A lag far below `period_s` is a delay of one sample.
void lag(std::span<const double> in, double period_s, double lag_s, double start,
         std::span<double> out);

/// How a lag of `next_s` weighs what reaches it within one sampling interval: late
/// moments more than early ones; 0 weighs alike, as an integrator does. Exact: (W1) of
/// docs/model.md.
struct IntervalWeight {
  double period_s = 1;
  double next_s = 0;

  /// Of exp(−t/lag_s), t from the start of the interval; 1 where the lag is endless.
  [[nodiscard]] double decay(double lag_s) const;
  /// Of 1 − t/end_s up to end_s ≤ period_s, 0 after it.
  [[nodiscard]] double ramp_down(double end_s) const;
};

/// What a lag makes of `signal`, as a mean over each interval with the weight of what
/// follows. Starts at rest in signal[0].
void lag_means(const IntervalWeight& weight, double lag_s, std::span<double> signal);

/// The same for a signal that moves in straight lines between samples; a lag of 0 leaves
/// it as it is.
void lag_of_lines(std::span<const double> in, double period_s, double lag_s,
                  std::span<double> out);

/// Dead time by any number of samples, a fraction of one included; in[0] before the
/// start. Within a sample the input of a lag counts the more the later it comes: exact
/// for one lag of `lag_s`; 0 weighs alike, as an integrator does.
void delay(std::span<const double> in, double period_s, double dead_time_s, double lag_s,
           std::span<double> out);

/// Response to `in` from rest in in[0] (an integrator starts at 0 and takes `in` as it
/// is); without the sensor's lag. `scratch` is resized to the length of `in`.
void respond(const ProcessShape& shape, double period_s, std::span<const double> in,
             std::vector<double>& scratch, std::span<double> out);

/// The lag of the fast part, which is faster than the slow one.
[[nodiscard]] double fast_lag_of(const ProcessShape& shape);

/// exp(-k·period/lag), k = 0, 1, …
void decay(double period_s, double lag_s, std::span<double> out);

}  // namespace workbench
