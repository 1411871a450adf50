// From a window of u and y to a verdict: the identifier.
//
// Life: new → start(window) → step(budget) until done → result. One object holds all
// scratch; nothing is allocated. See docs/model.md for the equations.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <variant>

#include "ident/full_rate_process.hpp"
#include "ident/identification.hpp"
#include "ident/interval_search.hpp"
#include "ident/model_gap.hpp"
#include "ident/movement.hpp"
#include "ident/structure_search.hpp"
#include "ident/valve_search.hpp"

namespace ident {

/// Identifies one window of at most `Capacity` samples.
///
/// `start` copies and scales the window (u to 0 … 1, y to zero mean and unit variance).
/// To save a copy of one's own, write it to `input` and start with that.
/// `step(budget)` does about `budget` passes over it and returns true when the result is
/// ready; `run` does all of it. Any finite input is accepted: what cannot be identified
/// gives Verdict::kUndecided or kBadData with its reason, never a number.
template <class Real, std::size_t Capacity>
class Identifier {
 public:
  static constexpr std::size_t kCapacity = Capacity;
  /// Fewer samples than this are undecided (kTooShort).
  static constexpr std::size_t kFewestSamples = 60;

  /// Where `start` puts u and y.
  struct Input {
    std::span<Real> u;
    std::span<Real> y;
  };
  /// For `count` ≤ Capacity samples; not while an identification is going on.
  [[nodiscard]] Input input(std::size_t count) {
    return {{u_.data(), count}, {y_.data(), count}};
  }
  /// u, y: equal lengths ≤ Capacity, evenly spaced, oldest first. `sp`: empty or of the
  /// same length; it is not copied and must stay as it is until `done`; one with a value
  /// that is not finite is ignored. `gain_sign`: ±1 where the sign of the process gain is
  /// known, else 0.
  void start(std::span<const Real> u, std::span<const Real> y, std::span<const Real> sp,
             int gain_sign = 0);
  /// At most about `budget` passes over the window. True when done.
  bool step(int budget);
  [[nodiscard]] bool done() const { return stage_ == Stage::kDone; }
  /// `start`, and `step` until done.
  const Identification<Real>& run(std::span<const Real> u, std::span<const Real> y,
                                  std::span<const Real> sp, int gain_sign = 0);
  /// The answer; meaningful when done.
  [[nodiscard]] const Identification<Real>& result() const { return result_; }
  /// Output of the two-path model over the window, units of y (free simulation).
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

  [[nodiscard]] StructureSearch<Real>& structure() {
    return *std::get_if<StructureSearch<Real>>(&search_);
  }
  [[nodiscard]] ValveSearch<Real>& valve() {
    return *std::get_if<ValveSearch<Real>>(&search_);
  }
  [[nodiscard]] const ValveSearch<Real>& valve() const {
    return *std::get_if<ValveSearch<Real>>(&search_);
  }
  [[nodiscard]] std::span<const Real> u() const { return {u_.data(), size_}; }
  [[nodiscard]] std::span<const Real> y() const { return {y_.data(), size_}; }
  [[nodiscard]] WindowView<Real> window() const {
    return {u(), y(), {ascending_.data(), size_}};
  }

  std::array<Real, Capacity> u_;        // scaled to 0 … 1
  std::array<Real, Capacity> y_;        // scaled, sign turned: positive process gain
  std::array<Real, Capacity> scratch_;  // simulated outputs, stem positions
  std::array<Real, Capacity> means_;    // y at the decimated rate; at last the setpoint
  std::array<Real, Capacity> stem_;     // x at the decimated rate; at last at the full
  std::array<unsigned char, Capacity> ascending_;
  std::size_t size_ = 0;
  std::span<const Real> setpoint_;  // as given; empty: unknown
  Real u_low_ = 0;
  Real u_range_ = 1;
  Real y_mean_ = 0;
  Real y_scale_ = 1;         // standard deviation of y
  Real y_range_ = 1;         // of the scaled y
  Movement<Real> movement_;  // of u_
  int sign_ = 1;             // of the process gain
  Stage stage_ = Stage::kDone;
  StructureCandidate<Real> two_path_;
  StructureCandidate<Real> linear_;
  // One place for both: the stages of the paths, and all others.
  std::variant<ValveSearch<Real>, StructureSearch<Real>> search_;
  IntervalSearch<Real> intervals_;
  ValveModel<Real> chosen_;
  FullRateProcess<Real> full_rate_;
  ModelGap<Real> gap_;
  Identification<Real> result_;
};

}  // namespace ident
