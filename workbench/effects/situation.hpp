// What is known about a recording and the model so far when an effect is considered.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "workbench/recording/recording.hpp"

namespace workbench {

/// A sticking stem as the identification sees it in u and y. Units of u.
struct SeenStem {
  double deadband = 0;
  double slip_ascending = 0;
  double slip_descending = 0;
  double start = 0;  ///< position before the first sample, less the first u
  double lag_s = 0;  ///< slower of the two lags behind it; 0: an integrator
};

/// Facts for starts, bounds and excitation tests. Spans live as long as their owner.
struct Situation {
  double period_s = 1;
  std::span<const double> u;
  std::span<const double> y;         ///< the modelled output
  std::span<const double> sp;        ///< setpoint of y; empty where unknown
  std::span<const double> residual;  ///< y minus the model so far; empty before the first
  std::span<const unsigned char> estimation;  ///< 1 where a sample may be fitted
  double first_lag_s = 0;                     ///< of the model so far; 0 where unknown
  double second_lag_s = 0;                    ///< 0 where it has none
  bool integrating = false;                   ///< the model so far integrates
  double u_low = 0;                           ///< least u
  double u_high = 0;
  double y_low = 0;
  double y_high = 0;
  double residual_std = 0;          ///< of the model so far; 0 where unknown
  double filled_share = 0;          ///< of the samples: none was read, the last is held
  std::span<const Load> loads;      ///< measured ones, each as long as u
  std::span<const SeenStem> stems;  ///< for effects that start from them; often empty
  std::span<const Piece> pieces;    ///< as in Recording
  int gain_sign = 0;                ///< that of a process gain in a loop; 0: not known

  [[nodiscard]] std::size_t samples() const { return u.size(); }
  [[nodiscard]] double duration_s() const {
    return period_s * static_cast<double>(u.size());
  }
  [[nodiscard]] double u_span() const { return u_high - u_low; }
  [[nodiscard]] double y_span() const { return y_high - y_low; }
  /// "512 s" after the first sample, "112 s of tuesday.csv" where there are several
  /// recordings; by the clock of the file, which does not stand still in a pause.
  [[nodiscard]] std::string when(double seconds, int digits = 4) const;
};

/// The situation before any model: u and y of equal length, at least 2 samples.
[[nodiscard]] Situation situation_of(std::span<const double> u, std::span<const double> y,
                                     double period_s);

/// Quantile of `values`, share 0 … 1, linear between order statistics. O(n log n).
[[nodiscard]] double quantile(std::span<const double> values, double share);

/// Times a signal turned around by more than `threshold` (> 0).
[[nodiscard]] int count_reversals(std::span<const double> signal, double threshold);

/// The same for u within the pieces of the recording: what lies between two of them is no
/// move of the valve.
[[nodiscard]] int reversals_of_u(const Situation& situation, double threshold);

/// True where u turned around at all, which is when a stem with friction acts.
[[nodiscard]] bool turns(const Situation& situation);

/// True where u rests at its lowest and at its highest but for passing moments, as a
/// switch does, or one whose rows are means: what changes its scale between the two, by
/// play, friction or a curve, does not show. O(n).
[[nodiscard]] bool takes_two_values(const Situation& situation);

/// Times a signal went `size` (> 0) away, either way, from where it was last counted.
[[nodiscard]] int count_moves(std::span<const double> signal, double size);

/// Stays of `signal` beyond `level` (below it when `above` is false): one for each run of
/// samples, and another for every `memory` samples that it lasts, since what is further
/// apart than the process remembers speaks for itself. `memory` ≥ 1; runs apart by fewer
/// than three samples are one.
[[nodiscard]] int count_stays(std::span<const double> signal, double level, bool above,
                              std::size_t memory);

/// Three first lags in samples, at least five: `memory` for count_stays.
[[nodiscard]] std::size_t memory_of(const Situation& situation);

/// Periods in samples of the strongest separate lines in the spectrum of the residual on
/// the estimation samples, from `longest` down to four samples, strongest first.
/// O(n log n); the grid is at least twice as fine as the resolution of the record.
[[nodiscard]] std::vector<double> strongest_periods(const Situation& situation,
                                                    double longest, int count);

/// Period in s of the strongest line of any signal, over three cycles or more.
[[nodiscard]] double strongest_period(std::span<const double> signal, double period_s);

/// Share of the variance of `signal` in a sinusoid of period `line_s`.
[[nodiscard]] double line_share(std::span<const double> signal, double period_s,
                                double line_s);

/// Step between the values of a signal that lives on a lattice, with the share of values
/// that do; {0, 0} where none is seen.
struct Lattice {
  double step = 0;
  double share = 0;
  std::size_t levels = 0;  ///< different values seen
};
[[nodiscard]] Lattice lattice_of(std::span<const double> signal);

}  // namespace workbench
