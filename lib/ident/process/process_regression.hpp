// The process behind a given valve: gain, dead time and start solved, poles given.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>

#include "ident/base/limits.hpp"
#include "ident/process/process_simulation.hpp"

namespace ident {

/// (P1) by variable projection for one valve and one pair of poles: for every dead time
/// the best non-negative gains, offset, drift and initial state follow from one pass
/// (Golub and Pereyra 1973). Simulation error throughout: y never enters the model.
///
/// Life: `start_fit` or `start_screen`, then `step` until it says true, then `result`; or
/// `fit` and `screen`, all at once. The spans must outlive the work.
template <class Real>
class ProcessRegression {
 public:
  /// Fits y from x (equal lengths, both roughly centred and scaled). Dead times from
  /// `first_delay` to `last_delay` ≤ kDelayTaps − 2 are tried. With `drift` false a
  /// constant offset only. Cost: one pass, taps + 10 multiplications a sample, taps + 20
  /// with a drift and a fast pole; then about 60 a dead time. `keeps_output`: the samples
  /// behind `y` stay as they are until `forget_output`; fits of the same ones with the
  /// same poles then share the sums that x has no part in, a third of the pass.
  void start_fit(std::span<const Real> x, std::span<const Real> y,
                 const ProcessPoles<Real>& poles, int first_delay, int last_delay,
                 bool drift, bool keeps_output = false);
  void forget_output() {
    own_ = {};
    screened_ = {};
  }

  /// The quick look that a search needs: an offset and one start (of the slow pole; a
  /// ramp when integrating) are taken out. Only `error`, `delay` and the gains are set.
  /// Cost: kDelayTaps + 10 multiplications a sample.
  void start_screen(std::span<const Real> x, std::span<const Real> y,
                    const ProcessPoles<Real>& poles, bool keeps_output = false);

  /// Some blocks of samples, or the solution; true when done.
  bool step();
  /// Of the next step, thousands of instructions of a Cortex-M4F.
  [[nodiscard]] int cost_of_step() const;
  /// The answer; when done.
  [[nodiscard]] const ProcessFit<Real>& result() const { return best_; }

 private:
  static constexpr int kNuisances = 4;  // offset, drift, both starts
  static constexpr int kBlock = 64;     // samples at a time
  static constexpr int kTail = kDelayTaps + 4;
  using Nuisances = std::array<Real, kNuisances>;

  // Sums with z(t − delay), over all t of the window.
  struct TapSums {
    Real own = 0;
    Real with_next = 0;  // with z(t − delay − 1)
    Nuisances with{};
  };

  // What the sums without x are made of.
  struct OwnSums {
    const Real* y = nullptr;
    std::size_t samples = 0;
    ProcessPoles<Real> poles;
    bool drift = false;
    bool known = false;  // the sums are there

    [[nodiscard]] bool operator==(const OwnSums&) const = default;
  };
  // Those of the screens of one y, for each pole.
  static constexpr int kScreened = 9;
  struct Screened {
    const Real* y = nullptr;
    std::size_t samples = 0;
    int count = 0;
    Real y_sum = 0;
    Real energy = 0;
    std::array<Real, kScreened> pole{};
    std::array<Nuisances, kScreened> sums{};
  };
  enum class Stage : unsigned char { kOwn, kTaps, kSolve };

  void start(std::span<const Real> x, std::span<const Real> y,
             const ProcessPoles<Real>& poles, int first, int last, bool drift,
             bool keeps_output);
  template <class Slow, class Fast>
  void add(Slow& slow, Fast& fast);
  template <class Slow, class Fast>
  void add_own(Slow& slow, Fast& fast);
  void end_own();
  template <class Slow, class Fast>
  void add_taps(Slow& slow, Fast& fast);
  template <class Slow, class Fast>
  void add_common(int count, Slow& slow, Fast& fast);
  template <class Slow, class Fast>
  void finish_taps(const Slow& slow, const Fast& fast);
  template <class Slow, class Fast>
  void add_before(Slow slow, Fast fast);
  [[nodiscard]] Real pole_of_screen() const {
    if constexpr (kLeastSizes) {
      return slow_start_.pole();
    } else {
      return plain_start_.pole();
    }
  }
  void recall_screen(int index);
  void remember_screen();
  void solve_fit();
  void solve_screen();
  [[nodiscard]] int cost_of_sample() const;
  [[nodiscard]] int blocks_at_once() const;

  std::span<const Real> x_;
  std::span<const Real> y_;
  PoleFilter<Real> filter_;
  StartColumn<Real> slow_start_;
  StartColumn<Real> fast_start_;
  // In the least sizes the columns above serve a screening, too.
  struct LeftOut {};
  [[no_unique_address]] std::conditional_t<kLeastSizes, LeftOut, PlainStart<Real>>
      plain_start_;
  int first_ = 0;  // taps
  int last_ = 0;
  int next_ = 0;  // sample
  bool screens_ = false;
  bool drift_ = false;
  bool keeps_ = false;  // what own_ says
  Stage stage_ = Stage::kSolve;
  OwnSums own_;
  Screened screened_;
  ProcessFit<Real> best_;
  std::array<Real, kSamplesBefore> before_;  // z(−1), z(−2) …
  std::array<Real, kBlock + 1> z_;           // a block of samples and the one before
  std::array<Real, kTail> slow_;             // the last samples, which not all taps reach
  std::array<Real, kTail> fast_;
  std::array<TapSums, kDelayTaps> taps_;
  std::array<Real, kDelayTaps> with_y_;         // Σ z(t − delay)·y(t)
  std::array<Nuisances, kNuisances> nuisance_;  // lower triangle; of own_, like these
  Nuisances nuisance_y_;
  Real energy_ = 0;
};

}  // namespace ident
