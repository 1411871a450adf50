// From a window of u and y to a verdict, in the window's own memory.
//
// Life: new → start(window) → step(budget) until done → result. One object holds all
// scratch; nothing is allocated. See docs/model.md for the equations.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <type_traits>
#include <variant>

#include "ident/base/configurations.hpp"
#include "ident/base/limits.hpp"
#include "ident/evidence/bounded_stem.hpp"
#include "ident/evidence/closed_loop_evidence.hpp"
#include "ident/evidence/curved_ladder.hpp"
#include "ident/evidence/cycle_memory.hpp"
#include "ident/evidence/evidence_pool.hpp"
#include "ident/evidence/stem_search.hpp"
#include "ident/gap/model_gap.hpp"
#include "ident/signal/movement.hpp"
#include "ident/signal/signal_scale.hpp"
#include "ident/two_path/structure_search.hpp"
#include "ident/valve/directional_lag.hpp"
#include "ident/valve/earlier_valve.hpp"
#include "ident/valve/full_rate_process.hpp"
#include "ident/valve/interval_search.hpp"
#include "ident/valve/valve_search.hpp"
#include "ident/verdict/cycle_comparison.hpp"
#include "ident/verdict/doubts.hpp"
#include "ident/verdict/identification.hpp"
#include "ident/verdict/judge.hpp"
#include "ident/verdict/oscillation_cause.hpp"
#include "ident/window_survey.hpp"

namespace ident {

/// How a window is looked at, and where what it says of each stick band is added to what
/// others said.
struct WindowOptions {
  EvidencePool* pool = nullptr;  ///< none: the window stands for itself
  float span = 0;    ///< of u, units of u, one for all windows; 0: this window's swing
  float weight = 1;  ///< share of the window that was in none before, 0 … 1
  /// A window without closed-loop evidence ends there: no model, no fit, no cause.
  bool ends_early = false;
  /// Without it only the linear model beside the two-path one is fitted. The verdict is
  /// the same: where it rests on the two-path model (few_turns() of doubts.hpp), that is
  /// fitted whatever stands here.
  bool two_path = true;
  /// Neither of these models nor the model gap, with the same exception: the verdict, its
  /// bands and all that they rest on are the same without them.
  bool verdict_only = false;
  /// A valve with a memory is looked for from later cycles, too (T9); where a start for
  /// another search is all that is wanted, the first do.
  bool later_cycles = true;
  /// Of the same loop, to start from, or none; as it is until `next_start` was asked for.
  const EarlierValve* earlier = nullptr;
};

/// Budget of the slices where nobody waits for the next sample.
inline constexpr int kLargeBudget = 1000;

/// Identifies one window of at most `Capacity` samples in the caller's memory: u and y
/// are scaled where they are (u to 0 … 1, y to zero mean and unit variance, turned where
/// the process gain is negative) and stay so; `scale_of_u` and `scale_of_y` lead back.
///
/// `step(budget)` works for about `budget` units of 100,000 instructions of a Cortex-M4F
/// and returns true when the result is ready; the dearest single piece takes about one.
/// Any finite input is accepted: what cannot be identified gives
/// Verdict::kUndecided or kBadData with its reason, never a number.
template <class Real, std::size_t Capacity>
class InPlaceIdentifier {
 public:
  static constexpr std::size_t kCapacity = Capacity;
  /// Fewer samples than this are undecided (kTooShort).
  static constexpr std::size_t kFewestSamples = 60;

  /// u, y: equal lengths ≤ Capacity, evenly spaced, oldest first. `sp`: empty or of the
  /// same length; one with a value that is not finite is ignored. All three belong to the
  /// identifier until `done`. `gain_sign`: ±1 where the sign of the process gain is
  /// known, else 0. `options`: its pool gets this window's ladder before anything is
  /// fitted.
  void start(std::span<Real> u, std::span<Real> y, std::span<const Real> sp,
             int gain_sign = 0, const WindowOptions& options = {});
  /// Goes on by about `budget` ≥ 1 units. True when done.
  bool step(int budget);
  [[nodiscard]] bool done() const { return stage_ == Stage::kDone; }
  /// The answer; meaningful when done.
  [[nodiscard]] const Identification<Real>& result() const { return result_; }
  /// What the next window should start from: the valve of this one if it was found to
  /// stick or to have play, else the one that this window started from. Meaningful when
  /// done.
  [[nodiscard]] EarlierValve next_start() const;
  /// Whether that one did, so that no other was looked for.
  [[nodiscard]] bool searched() const;
  /// From the samples as they stand back to those that came: value · factor + offset.
  [[nodiscard]] const SignalScale<Real>& scale_of_u() const { return scale_of_u_; }
  [[nodiscard]] const SignalScale<Real>& scale_of_y() const { return scale_of_y_; }
  /// Output of the two-path model over the window, units of y (free simulation). This and
  /// the next two need u and y as `start` left them.
  void simulate_two_path(std::span<Real> y) const;
  /// Output of the physical valve and its process over the window, units of y.
  void simulate_valve(std::span<Real> y) const;
  /// Stem position of the physical valve over the window, units of u.
  void stem_positions(std::span<Real> x) const;

 private:
  enum class Stage : unsigned char {
    kSurvey,
    kLadder,
    kCycle,
    kBounds,
    kTwoPath,
    kLinear,
    kValve,
    kWeigh,
    kReference,
    kCompare,
    kUneven,
    kIntervals,
    kLinearProcess,
    kCrossover,
    kLinearOutput,
    kMargin,
    kSetpoint,
    kStem,
    kProcess,
    kStemEvidence,
    kStemSearched,
    kStemConfirmed,
    kBesideSetpoint,
    kBesideCurve,
    kJudge,
    kGapStem,
    kGapOutput,
    kGap,
    kDone
  };

  void finish(Reason reason);
  bool work(int budget);
  bool survey_some();
  void after_survey();
  void take_two_path();
  void start_valve();
  void find_valve();
  void after_paths();
  void judge_loop();
  void explain_next();
  void begin_weighing();
  void weigh();
  bool solve_process(int budget);
  void begin_process(const ValveModel<Real>& model, std::span<const Real> stem);
  bool simulate_process(int budget);
  void begin_output(std::span<const Real> stem);
  void start_intervals();
  [[nodiscard]] LinearLoop<Real> linear_loop() const;
  void look_at_loop();
  void look_at_crossover();
  void look_at_margin();
  void look_at_setpoint();
  void after_ladder();
  void after_cycle();
  void look_at_bounds();
  void after_bounds();
  void look_beside_rung();
  void take_ladder();
  [[nodiscard]] bool nothing_sticks() const;
  void take_bands();
  void weigh_stem();
  void search_stem();
  void confirm_stem();
  void take_searched_stem();
  [[nodiscard]] bool setpoint_moves() const {
    return std::any_of(setpoint_.begin(), setpoint_.end(),
                       [this](Real sp) { return sp != setpoint_[0]; });
  }
  void look_beside_setpoint();
  void take_beside_setpoint();
  void look_beside_curve();
  void take_beside_curve();
  [[nodiscard]] Reason judged() const;
  void take_verdict();
  void tell_bands_seen_ahead();
  void take_stem();
  void lay_gap();
  void start_gap();
  bool look_for_gap(int budget);
  void take_gap();
  [[nodiscard]] std::size_t samples_before_searched() const {
    return static_cast<std::size_t>(valve().window().u.data() - u_.data());
  }
  [[nodiscard]] bool placed();
  [[nodiscard]] StickSlipValve<Real> chosen_valve() const;
  void scaled_stem(std::span<Real> x) const;
  [[nodiscard]] EvidenceWindow<Real> evidence_window(OneStepSums<Real>& sums);
  void begin_comparison();
  void compare_cycles();
  void after_uneven();

  // The valve is searched on no more than this many (decimated) samples, the newest ones;
  // a window that is no longer is searched whole.
  static constexpr std::size_t kMostSearched =
      Capacity <= kStandardWindow ? Capacity : 2000;
  // Decimation leaves at least this many samples in all.
  static constexpr std::size_t kFewestSearched = 600;
  static constexpr bool kDecimates = Capacity >= 2 * kFewestSearched;
  struct ValveStage {
    ValveSearch<Real> search;
    // x at the decimated rate, at last at the full one; or stems while they are tracked;
    // or the sums that the chosen stem is weighed with.
    union {
      std::array<Real, Capacity> stem;
      typename ValveSearch<Real>::Stems stems;
      OneStepSums<Real> sums;
    };
    ValveStage() : stem() {}
  };
  // What is left out takes no room.
  struct LeftOut {};
  struct LadderStage {
    OneStepSums<Real> sums;
    Ladder<Real> ladder;
    struct Rivals {
      CycleMemory<Real> memory;
      BoundedStem<Real> bounded;
    };
    [[no_unique_address]] std::conditional_t<kStemSearch, Rivals, LeftOut> rivals;
  };
  static_assert(kMostSearched == Capacity || 2 * kMostSearched <= Capacity);

  [[nodiscard]] WindowSurvey<Real>& survey() {
    return *std::get_if<WindowSurvey<Real>>(&search_);
  }
  using TwoPathStage = std::conditional_t<kTwoPathSearch, StructureSearch<Real>, LeftOut>;
  struct EvidenceStage {
    ClosedLoopEvidence<Real> asked;
    [[no_unique_address]] std::conditional_t<kStemSearch, StemSearch<Real>, LeftOut>
        search;
  };
  using GapStage = std::conditional_t<kModelGap, ModelGap<Real>, LeftOut>;

  [[nodiscard]] TwoPathStage& structure() { return *std::get_if<TwoPathStage>(&search_); }
  [[nodiscard]] LadderStage& ladder_stage() {
    return *std::get_if<LadderStage>(&search_);
  }
  [[nodiscard]] EvidenceStage& evidence_stage() {
    return *std::get_if<EvidenceStage>(&last_);
  }
  [[nodiscard]] ClosedLoopEvidence<Real>& closed_loop() { return evidence_stage().asked; }
  [[nodiscard]] ValveStage& valve_stage() { return *std::get_if<ValveStage>(&search_); }
  [[nodiscard]] ValveSearch<Real>& valve() { return valve_stage().search; }
  [[nodiscard]] const ValveSearch<Real>& valve() const {
    return std::get_if<ValveStage>(&search_)->search;
  }
  [[nodiscard]] CycleComparison<Real>& comparison() {
    return *std::get_if<CycleComparison<Real>>(&last_);
  }
  [[nodiscard]] IntervalSearch<Real>& intervals() {
    return *std::get_if<IntervalSearch<Real>>(&last_);
  }
  [[nodiscard]] GapStage& gap() { return *std::get_if<GapStage>(&last_); }
  [[nodiscard]] Real u_range() const { return scale_of_u_.factor; }
  /// Standard deviation of y.
  [[nodiscard]] Real y_scale() const { return std::abs(scale_of_y_.factor); }
  [[nodiscard]] std::span<const Real> u() const { return u_; }
  [[nodiscard]] std::span<const Real> y() const { return y_; }
  [[nodiscard]] WindowView<Real> window() const {
    return {u(), y(), {ascending_.data(), size_}};
  }

  std::span<Real> u_;  // scaled to 0 … 1
  std::span<Real> y_;  // scaled, sign turned: positive process gain
  // Simulated outputs, stem positions; behind them, while a valve is searched at a lower
  // rate, y at that rate.
  std::array<Real, Capacity> scratch_;
  std::array<unsigned char, Capacity> ascending_;
  std::size_t size_ = 0;
  WindowOptions options_;
  std::span<const Real> setpoint_;  // as given; empty: unknown
  SignalScale<Real> scale_of_u_;
  SignalScale<Real> scale_of_y_;  // its factor has the sign of the process gain
  Movement<Real> movement_;       // of u_
  Stage stage_ = Stage::kDone;
  [[no_unique_address]] std::conditional_t<kTwoPathSearch, StructureCandidate<Real>,
                                           LeftOut>
      two_path_;
  // One place for all, one after the other.
  std::variant<std::monostate, WindowSurvey<Real>, LadderStage, TwoPathStage, ValveStage>
      search_;
  ValveModel<Real> chosen_;
  // Of a stem before the first sample, where that had no part in the search.
  struct Placing {
    int next = 0;
    Real start = 0;
    Real error = 0;
  };
  struct Whole {};
  [[no_unique_address]] std::conditional_t<(kMostSearched < Capacity), Placing, Whole>
      placing_;
  FullRateProcess<Real> full_rate_;
  struct StaysHere {};
  using Elsewhere =
      std::conditional_t<kStemSearch, typename ValveSearch<Real>::Elsewhere, StaysHere>;
  struct NotAsked {};
  using Uneven = std::conditional_t<kStemSearch, DirectionalLag<Real>, NotAsked>;
  struct NoCurve {};
  using BesideCurve = std::conditional_t<kStemSearch, CurvedLadder<Real>, NoCurve>;
  // One after the other.
  std::variant<std::monostate, Elsewhere, CycleComparison<Real>, Uneven,
               IntervalSearch<Real>, GapStage, EvidenceStage, BesideCurve>
      last_;
  Identification<Real> result_;
};

}  // namespace ident
