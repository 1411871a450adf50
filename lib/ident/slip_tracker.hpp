// Where a resticking valve slipped: a bundle of stems that the process output keeps in
// step.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "ident/pattern_search.hpp"
#include "ident/process_regression.hpp"
#include "ident/quick_random.hpp"
#include "ident/valve_model.hpp"

namespace ident {

/// Improves a valve that resticks, with its process, on a whole window at once.
///
/// A simulation of such a valve remembers every slip; a stick band that is 2 % off loses
/// step after some cycles, and its error says nothing any more. Here the valve does not
/// run free: kStems stems go through the window together, each with a stick band drawn
/// anew after every slip, and those whose output leaves y are replaced by copies of those
/// that stay (a particle filter; Doucet, de Freitas & Gordon 2001). The slips of the best
/// stem then give the model (expectation-maximisation): between two slips the valve held,
/// at a slip it did not, which bounds the slip of each stroke from both sides; deadband,
/// poles and gain follow from the regression of y on the stem that these slips make.
///
/// Life: `start` or `resume`, then `begin_round` → `step` until it says true, as often as
/// wanted; `best` is the round with the smallest misfit so far. A fixed sequence of
/// random numbers: same data, same answer. Memory: kStems lists of kMostSlips slips, 2
/// bytes each. Cost of a round: kStems · samples valve steps and kFits passes of the
/// regression.
template <class Real>
class SlipTracker {
 public:
  static constexpr int kStems = 40;
  /// Later samples have no part in a round. What fits the device, and what the host can
  /// afford.
  static constexpr int kMostSlips = sizeof(Real) < sizeof(double) ? 92 : 128;
  static constexpr int kFits = 50;

  /// What a round knows; enough to go on from it later.
  struct State {
    ValveModel<Real>
        model;        ///< its error is that of the tracked stem on the samples that
                      ///< were used, not of a free simulation; it has no start
    Real misfit = 0;  ///< standard deviation of y less the stem's output; that of y is 1
    Real origin = 0;  ///< stem position that the output is counted from
    Real drift = 0;   ///< of y over half a window, beside the valve
    Real gain = 0;    ///< of the slow pole's input
  };

  /// `model`: where to start, fitted to the first `active` samples of y with stem
  /// positions x[0] … x[active − 1]. `x` and `scratch` have the length of window.y and
  /// are overwritten; `regression` and all spans must outlive the rounds.
  void start(const SearchWindow<Real>& window, const ValveModel<Real>& model,
             std::size_t active, std::span<Real> x, std::span<Real> scratch,
             ProcessRegression<Real>& regression);
  /// Goes on from an earlier round on the same window, with a longer memory.
  void resume(const State& state);
  /// `spread`: standard deviation of the stick bands in the bundle, as a share of them.
  void begin_round(Real spread);
  /// About one pass of the regression; true when the round is over.
  bool step();
  /// The best round so far, or the model of `start` before the first.
  [[nodiscard]] const State& best() const { return best_; }

 private:
  struct Stem {
    Real position, up, down;  // up, down: distances from u at which it slips
    Real lagged, output, last_output;
    Real start;
    int slips;
    std::array<std::int16_t, kMostSlips> when;  // index of u plus 1, negative: down
  };

  void take_free_fit(std::size_t samples);
  void filter_output(Real pole);
  void release(Stem& stem);
  void follow(std::size_t t);
  void replace_lost(Real total);
  void lay_path(const Stem& stem, Real deadband);
  void begin_fit();
  Real fit_at(const typename PatternSearch<Real>::Point& point, bool all_delays);
  void bound_slips(const Stem& stem);
  void finish_round();

  SearchWindow<Real> window_;
  std::span<Real> x_;
  std::span<Real> filtered_;  // y as the observer's error sees it
  ProcessRegression<Real>* regression_ = nullptr;
  PatternSearch<Real> pattern_;
  std::array<Stem, kStems> stems_;
  std::array<Real, kStems> weight_;  // log-likelihoods, the largest 0
  State best_;
  State now_;
  Real spread_ = 0;
  Real sigma_ = 1;
  Real correction_ = 0;   // share of its error that the output of a stem forgets
  std::size_t next_ = 0;  // sample of y that is followed next
  std::size_t used_ = 0;  // samples of y in this round
  const Stem* found_ = nullptr;
  bool following_ = false;
  bool started_ = false;  // the first round replaces the model of `start` in any case
  QuickRandom<Real> random_;
};

}  // namespace ident
