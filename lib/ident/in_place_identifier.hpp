// From a window of u and y to a verdict, in the window's own memory.
//
// Life: new → start(window) → step(budget) until done → result. One object holds all
// scratch; nothing is allocated. See docs/model.md for the equations.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <variant>

#include "ident/configurations.hpp"
#include "ident/full_rate_process.hpp"
#include "ident/identification.hpp"
#include "ident/interval_search.hpp"
#include "ident/model_gap.hpp"
#include "ident/movement.hpp"
#include "ident/signal_scale.hpp"
#include "ident/structure_search.hpp"
#include "ident/valve_search.hpp"

namespace ident {

/// Identifies one window of at most `Capacity` samples in the caller's memory: u and y
/// are scaled where they are (u to 0 … 1, y to zero mean and unit variance, turned where
/// the process gain is negative) and stay so; `scale_of_u` and `scale_of_y` lead back.
///
/// `step(budget)` does about `budget` passes over the window and returns true when the
/// result is ready. Any finite input is accepted: what cannot be identified gives
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
  /// known, else 0.
  void start(std::span<Real> u, std::span<Real> y, std::span<const Real> sp,
             int gain_sign = 0);
  /// At most about `budget` passes over the window. True when done.
  bool step(int budget);
  [[nodiscard]] bool done() const { return stage_ == Stage::kDone; }
  /// The answer; meaningful when done.
  [[nodiscard]] const Identification<Real>& result() const { return result_; }
  /// From the scaled u or y back: value · factor + offset. From `start` on.
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
  enum class Stage : unsigned char { kTwoPath, kLinear, kValve, kIntervals, kGap, kDone };

  void finish(Verdict verdict, Reason reason);
  bool scale();
  void choose_sign(int gain_sign);
  void look_at_signals();
  void take_two_path();
  void start_valve();
  void start_intervals();
  void take_valve();
  void start_gap();
  void take_gap();
  void look_at_loop();
  void scaled_stem(std::span<Real> x) const;
  [[nodiscard]] std::span<const Real> simulate_searched(const ValveModel<Real>& model);
  void compare_cycles();

  // The valve is searched on no more than this many (decimated) samples, the newest ones;
  // a window that is no longer is searched whole.
  static constexpr std::size_t kMostSearched =
      Capacity <= kStandardWindow ? Capacity : 2000;
  struct ValveStage {
    ValveSearch<Real> search;
    // x at the decimated rate and then, where it is not y itself, y at that rate; at last
    // x at the full rate.
    std::array<Real, Capacity> stem;
  };
  static_assert(kMostSearched == Capacity || 2 * kMostSearched <= Capacity);

  [[nodiscard]] StructureSearch<Real>& structure() {
    return *std::get_if<StructureSearch<Real>>(&search_);
  }
  [[nodiscard]] ValveStage& valve_stage() { return *std::get_if<ValveStage>(&search_); }
  [[nodiscard]] ValveSearch<Real>& valve() { return valve_stage().search; }
  [[nodiscard]] const ValveSearch<Real>& valve() const {
    return std::get_if<ValveStage>(&search_)->search;
  }
  [[nodiscard]] std::span<const Real> u() const { return u_; }
  [[nodiscard]] std::span<const Real> y() const { return y_; }
  [[nodiscard]] WindowView<Real> window() const {
    return {u(), y(), {ascending_.data(), size_}};
  }

  std::span<Real> u_;                   // scaled to 0 … 1
  std::span<Real> y_;                   // scaled, sign turned: positive process gain
  std::array<Real, Capacity> scratch_;  // simulated outputs, stem positions
  std::array<unsigned char, Capacity> ascending_;
  std::size_t size_ = 0;
  std::span<const Real> setpoint_;  // as given; empty: unknown
  SignalScale<Real> scale_of_u_;
  SignalScale<Real> scale_of_y_;  // its factor has the sign of the process gain
  Real u_low_ = 0;
  Real u_range_ = 1;
  Real y_mean_ = 0;
  Real y_scale_ = 1;         // standard deviation of y
  Movement<Real> movement_;  // of u_
  int sign_ = 1;             // of the process gain
  Stage stage_ = Stage::kDone;
  StructureCandidate<Real> two_path_;
  StructureCandidate<Real> linear_;
  // One place for both: the stages of the paths, and all others.
  std::variant<ValveStage, StructureSearch<Real>> search_;
  IntervalSearch<Real> intervals_;
  ValveModel<Real> chosen_;
  FullRateProcess<Real> full_rate_;
  ModelGap<Real> gap_;
  Identification<Real> result_;
};

}  // namespace ident
