// The process behind a given valve: gain, dead time and start solved, poles given.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "ident/process_simulation.hpp"

namespace ident {

/// Variable projection for one valve and one pair of poles: for every dead time the best
/// non-negative gains, offset, drift and initial state follow from one pass (Golub and
/// Pereyra 1973). Simulation error throughout: y never enters the model.
///
/// Life: `start_fit` or `start_screen`, then `step` until it says true, then `result`; or
/// `fit` and `screen`, all at once. The spans must outlive the work.
template <class Real>
class ProcessRegression {
 public:
  /// Fits y from x (equal lengths, both roughly centred and scaled). Dead times from
  /// `first_delay` to `last_delay` ≤ kDelayTaps − 2 are tried. With `drift` false a
  /// constant offset only. Cost: one pass, taps + 10 multiplications a sample, taps + 20
  /// with a drift and a fast pole; then about 60 a dead time.
  void start_fit(std::span<const Real> x, std::span<const Real> y,
                 const ProcessPoles<Real>& poles, int first_delay, int last_delay,
                 bool drift);
  ProcessFit<Real> fit(std::span<const Real> x, std::span<const Real> y,
                       const ProcessPoles<Real>& poles, int first_delay, int last_delay,
                       bool drift);

  /// The quick look that a search needs: an offset and one start (of the slow pole; a
  /// ramp when integrating) are taken out. Only `error`, `delay` and the gains are set.
  /// Cost: kDelayTaps + 10 multiplications a sample.
  void start_screen(std::span<const Real> x, std::span<const Real> y,
                    const ProcessPoles<Real>& poles);
  ProcessFit<Real> screen(std::span<const Real> x, std::span<const Real> y,
                          const ProcessPoles<Real>& poles);

  /// Some blocks of samples, or the solution; true when done.
  bool step();
  /// Of the next step, thousands of instructions of a Cortex-M4F.
  [[nodiscard]] int cost_of_step() const;
  /// The answer; when done.
  [[nodiscard]] const ProcessFit<Real>& result() const { return best_; }

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

  void start(std::span<const Real> x, std::span<const Real> y,
             const ProcessPoles<Real>& poles, int first, int last, bool drift);
  template <class Slow, class Fast>
  bool accumulate(Slow& slow, Fast& fast);
  template <class Slow, class Fast>
  void finish_taps(const Slow& slow, const Fast& fast);
  void solve_fit();
  void solve_screen();
  [[nodiscard]] int cost_of_sample() const;
  [[nodiscard]] int blocks_at_once() const;

  std::span<const Real> x_;
  std::span<const Real> y_;
  PoleFilter<Real> filter_;
  StartColumn<Real> slow_start_;
  StartColumn<Real> fast_start_;
  PlainStart<Real> plain_start_;
  int first_ = 0;  // taps
  int last_ = 0;
  int next_ = 0;  // sample
  bool drift_ = false;
  bool screens_ = false;
  bool summed_ = false;  // all samples are
  ProcessFit<Real> best_;
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
