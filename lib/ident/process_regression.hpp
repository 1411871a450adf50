// The process behind a given valve: gain, dead time and start solved, poles given.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace ident {

/// The nonlinear part of the process: two real poles in 0 … 1, per sample of the data
/// that it is fitted to. pole 0: none; slow_pole 1: integrating.
template <class Real>
struct ProcessPoles {
  Real slow = 0;
  Real fast = 0;
};

/// y(t) = gain_a·z(t − delay) + gain_b·z(t − delay − 1) + offset + drift·t + start, where
/// z is x − x(0) through the poles with unit steady gain, at rest before the window; when
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

/// Variable projection for one valve and one pair of poles: for every dead time the best
/// non-negative gains, offset, drift and initial state follow from one pass (Golub and
/// Pereyra 1973). Simulation error throughout: y never enters the model.
template <class Real>
class ProcessRegression {
 public:
  /// Fits y from x (equal lengths, both roughly centred and scaled). Dead times from
  /// `first_delay` to `last_delay` ≤ kDelayTaps − 2 are tried. With `drift` false a
  /// constant offset only. Cost: one pass, taps + 10 multiplications a sample, taps + 20
  /// with a drift and a fast pole; then about 60 a dead time.
  ProcessFit<Real> fit(std::span<const Real> x, std::span<const Real> y,
                       const ProcessPoles<Real>& poles, int first_delay, int last_delay,
                       bool drift);

  /// The quick look that a search needs: an offset and one start (of the slow pole; a
  /// ramp when integrating) are taken out. Only `error`, `delay` and the gains are set.
  /// Cost: kDelayTaps + 10 multiplications a sample.
  ProcessFit<Real> screen(std::span<const Real> x, std::span<const Real> y,
                          const ProcessPoles<Real>& poles);

  /// The simulated output of a fit.
  void simulate(std::span<const Real> x, const ProcessPoles<Real>& poles,
                const ProcessFit<Real>& fit, std::span<Real> y) const;

 private:
  static constexpr int kNuisances = 4;  // offset, drift, both starts
  static constexpr int kBlock = 128;    // samples at a time
  using Nuisances = std::array<Real, kNuisances>;

  // Sums with z(t − delay), over all t of the window.
  struct TapSums {
    Real own = 0;
    Real with_next = 0;  // with z(t − delay − 1)
    Nuisances with{};
  };

  template <class Slow, class Fast>
  void accumulate(std::span<const Real> x, std::span<const Real> y,
                  const ProcessPoles<Real>& poles, int first, int last, bool drift,
                  Slow& slow, Fast& fast);
  template <class Slow, class Fast>
  void finish_taps(std::span<const Real> y, int first, int last, const Slow& slow,
                   const Fast& fast);

  // One block of samples; of z also the sample before.
  std::array<Real, kBlock + 1> z_;
  std::array<Real, kBlock> ramp_;
  std::array<Real, kBlock> slow_;
  std::array<Real, kBlock> fast_;
  std::array<TapSums, kDelayTaps> taps_;
  std::array<Real, kDelayTaps> with_y_;         // Σ z(t − delay)·y(t)
  std::array<Nuisances, kNuisances> nuisance_;  // lower triangle
  Nuisances nuisance_y_;
  Real energy_ = 0;
};

}  // namespace ident
