// Linear dynamics between valve and output: dead time, lags, integrator; sampled exactly
// for an input that is constant between samples.
#pragma once

#include <span>
#include <vector>

namespace workbench {

/// A monotone curve over from … to with both ends fixed, whose slope changes by the
/// factor exp(curvature) from one end to the other; 0 is a straight line.
struct Curve {
  double curvature = 0;
  double from = 0;
  double to = 0;

  [[nodiscard]] double slope(double z) const;
};

/// The dynamics of a process with unit gain. Times in s, 0 = absent.
struct ProcessShape {
  double first_lag_s = 0;  ///< ignored where `integrating`
  double second_lag_s = 0;
  double dead_time_s = 0;
  double sensor_lag_s = 0;  ///< acts behind the loads and the overflow
  /// Content of each storage over its outflow: where it is steep, gain and lag are both
  /// large, as in a tank that empties by its own head. Straight: constant lags.
  Curve storage;
  bool integrating = false;  ///< ∫ v dt in s times units of v, instead of the first lag
};

/// First-order lag with unit gain. out[0] = `start`; in[k] acts from sample k to k + 1.
/// `in` and `out` may be the same. A lag far below `period_s` is a delay of one sample.
void lag(std::span<const double> in, double period_s, double lag_s, double start,
         std::span<double> out);

/// Mean over each sampling interval of a lag fed with the same values: the input of what
/// follows. Starts at rest in in[0]. `in` and `out` may be the same.
void lag_means(double period_s, double lag_s, std::span<double> signal);

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

/// exp(-k·period/lag), k = 0, 1, …
void decay(double period_s, double lag_s, std::span<double> out);

}  // namespace workbench
