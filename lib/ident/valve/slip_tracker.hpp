// Where a valve with a memory slipped: a bundle of stems that the process output keeps in
// step.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "ident/base/limits.hpp"
#include "ident/base/pattern_search.hpp"
#include "ident/base/quick_random.hpp"
#include "ident/process/process_regression.hpp"
#include "ident/valve/valve_model.hpp"

namespace ident {

/// Improves a valve that stops or resticks, with its process, on a whole window at once.
///
/// A simulation of such a valve remembers every slip; a stick band that is 2 % off loses
/// step after some cycles, and its error says nothing any more. Here the valve does not
/// run free: kStems stems go through the window together, each with a deadband and a dead
/// time of its own and with bounds for the slip of each stroke, which every slip tightens
/// and between which the next one is drawn; those whose output leaves y are replaced by
/// copies of those that stay, varied (a particle filter; Doucet, de Freitas & Gordon
/// 2001). The slips of the best stem then give the model (expectation-maximisation):
/// between two slips the valve held, at a slip it did not, which bounds the slip of each
/// stroke from both sides; deadband, poles and gain follow from the regression of y on
/// the stem that these slips make.
///
/// Life: `start` or `resume`, then `begin_round` → `step` until it says true, as often as
/// wanted; `best` is the round with the smallest misfit so far. A fixed sequence of
/// random numbers: same data, same answer. Memory: kStems lists of kMostSlips slips, 2
/// bytes each. Cost of a round: kStems · samples valve steps and kFits passes of the
/// regression.
template <class Real>
class SlipTracker {
 public:
  static constexpr int kStems = kMostStems;
  /// Later samples have no part in a round. What fits the device, and what the host can
  /// afford.
  static constexpr int kMostSlips = sizeof(Real) < sizeof(double) ? kMostStemSlips : 128;
  static constexpr int kFits = 50;
  static constexpr int kOutputs = 3;  ///< of a stem that are remembered

  /// What a round knows; enough to go on from it later.
  struct State {
    ValveModel<Real> model;  ///< its error is that of the tracked stem on the samples
                             ///< that were used, not of a free simulation
    bool followed = false;   ///< false: every stem ran out of room for its slips, and the
                             ///< misfit is a guess
    Real misfit = 0;  ///< standard deviation of y less the stem's output; that of y is 1
    Real origin = 0;  ///< stem position that the output is counted from
    Real drift = 0;   ///< of y over half a window, beside the valve
    Real gain = 0;    ///< of the slow pole's input
    Real start = 0;   ///< stem position before the first sample, of the tracked stem
  };

  /// What one stem knows. Between two slips the valve needs only u at the first of them.
  struct Stem {
    Real slipped_at;         // u at its newest slip; before the first its position
    Real deadband;           // its own
    Real position;           // of the stem
    Real upper, lower;       // u beyond which it slips next
    Real highest, lowest;    // u since then
    Real least[2], most[2];  // bounds of the slip, for either stroke
    Real late;               // its dead time beyond that of all
    Real lagged;
    Real output[kOutputs];  // newest first
    Real start;
    std::int8_t direction;  // of the newest slip, 0 before the first
    bool moves;             // still follows u
    std::uint8_t slips;
    std::array<std::int16_t, kMostSlips> when;  // index of u plus 1, negative: down
  };
  /// Room for them: the tracker's while they follow a window, anyone's while a round fits
  /// a model to what the best of them found.
  using Stems = std::array<Stem, kStems>;

  /// `model`: where to start, fitted to the first `active` samples of y with stem
  /// positions x[0] … x[active − 1]. `x` and `scratch` have the length of window.y and
  /// are overwritten; so are the `stems`, which may lie where x lies. `regression`, the
  /// stems and all spans must outlive the rounds.
  void start(const SearchWindow<Real>& window, const ValveModel<Real>& model,
             std::size_t active, std::span<Real> x, std::span<Real> scratch, Stems& stems,
             ProcessRegression<Real>& regression);
  /// Goes on from an earlier round on the same window, with a longer memory. To `depart`
  /// is to forget how well it did: the next round is taken in any case.
  void resume(const State& state, bool depart);
  /// Begins to measure the misfit that a stem with the positions in x would have in the
  /// next round, its process behind these poles: one pass of the regression, by `step`.
  /// Overwrites the scratch.
  void measure(const ProcessPoles<Real>& poles);
  /// When it is measured.
  [[nodiscard]] Real misfit() const;
  /// `spread`: how far from the model's the bands of the bundle are, as a share of the
  /// wider stick band.
  void begin_round(Real spread);
  /// All stems over some samples, or a piece of a regression; true when the round, or
  /// the measurement, is over.
  bool step();
  /// Of the last step, thousands of instructions of a Cortex-M4F.
  [[nodiscard]] int cost() const { return cost_; }
  /// The best round so far, or the model of `start` before the first.
  [[nodiscard]] const State& best() const { return best_; }

 private:
  static constexpr Real kNotFiltered = -1;

  enum class Doing : std::uint8_t { kFollow, kFilter, kRegress, kFinish };
  using Point = typename PatternSearch<Real>::Point;

  void take_free_fit(std::size_t samples);
  void filter_output(Real pole);
  void release(Stem& stem);
  [[nodiscard]] static bool still_moves(Stem& stem, Real u);
  void slip(Stem& stem, bool up, int u_index);
  void vary(Stem& stem);
  void move(Stem& stem, Real u, int u_index);
  Real go_on(Stem& stem, int first, Real low, Real high);
  void follow(std::size_t t);
  void replace_lost();
  void resample(const std::array<Real, kStems>& likelihood, Real total);
  // Sum of the positions of a stem that holds for a sample of y, added one by one like
  // those of a stem that moves: the same bits.
  [[nodiscard]] static Real held(Real position, int decimation) {
    Real sum = 0;
    for (int k = 0; k < decimation; ++k) {
      sum += position;
    }
    return sum;
  }
  void lay_path(const Stem& stem, Real deadband);
  void follow_some();
  void begin_fits();
  [[nodiscard]] int followed_at_once() const;
  [[nodiscard]] Real seen_slow(const ProcessPoles<Real>& poles) const;
  void regress(const ProcessPoles<Real>& poles, const DelayRange& delays);
  void begin_fit_at(const Point& point);
  [[nodiscard]] bool at_best() const;
  void take_fit();
  void propose(bool tried);
  [[nodiscard]] int stopped_at(int slip, int next) const;
  void bound_slips(const Stem& stem);
  void finish_round();

  SearchWindow<Real> window_;
  std::span<Real> x_;
  std::span<Real> filtered_;  // y as the observer's error sees it
  ProcessRegression<Real>* regression_ = nullptr;
  PatternSearch<Real> pattern_;
  Stems* stems_ = nullptr;
  std::array<Real, kStems> weight_;  // log-likelihoods, the largest 0
  State best_;
  State now_;
  Real spread_ = 0;
  Real reach_ = 0;   // of the bands, from the model's
  Real widest_ = 0;  // stick band of the model
  Real least_deadband_ = 0;
  Real most_deadband_ = 0;
  Real widening_ = 0;  // of the bounds of a slip at each of them
  int delay_ = 0;      // samples of y, of all stems
  Real sigma_ = 1;
  Real correction_ = 0;   // share of its error that the output of a stem forgets
  std::size_t next_ = 0;  // sample of y that is followed next
  std::size_t used_ = 0;  // samples of y in this round
  Stem found_;            // the best of a round
  Real filtered_pole_ = kNotFiltered;  // slow pole that the filtered output is made for
  Point point_{};                      // that is fitted
  ProcessPoles<Real> poles_;
  int cost_ = 0;
  int replaced_ = 0;  // stems, in this piece
  Doing doing_ = Doing::kFinish;
  bool first_fit_ = false;  // of this round: all dead times
  bool laid_ = false;       // the path of the point, in x_
  bool settled_ = false;    // the dead times near that of the best point were tried there
  bool measuring_ = false;
  bool integrating_ = false;
  bool started_ = false;  // the first round replaces the model of `start` in any case
  QuickRandom<Real> random_;
};

}  // namespace ident
