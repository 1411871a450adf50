// From a window of u and y to a verdict: the identifier.
//
// Life: new → start(window) → step(budget) until done → result. One object holds all
// scratch; nothing is allocated. See docs/model.md for the equations.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "ident/identification.hpp"
#include "ident/lagged_gram.hpp"
#include "ident/output_error.hpp"
#include "ident/reversals.hpp"
#include "ident/structure_search.hpp"
#include "ident/valve_search.hpp"

namespace ident {

/// Identifies one window of at most `Capacity` samples.
///
/// `start` copies and scales the window (u to 0 … 1, y to zero mean and unit variance).
/// `step(budget)` does about `budget` passes over it and returns true when the result is
/// ready; `run` does all of it. Any finite input is accepted: what cannot be identified
/// gives Verdict::kUndecided or kBadData with its reason, never a number.
template <class Real, std::size_t Capacity>
class Identifier {
 public:
  static constexpr std::size_t kCapacity = Capacity;
  /// Fewer samples than this are undecided (kTooShort).
  static constexpr std::size_t kFewestSamples = 60;

  /// u, y: equal lengths ≤ Capacity, evenly spaced, oldest first. `sp`: empty or of the
  /// same length. `gain_sign`: ±1 where the sign of the process gain is known, else 0.
  void start(std::span<const Real> u, std::span<const Real> y, std::span<const Real> sp,
             int gain_sign = 0);
  /// At most about `budget` passes over the window. True when done.
  bool step(int budget);
  [[nodiscard]] bool done() const { return stage_ == Stage::kDone; }
  /// start and step until done.
  const Identification<Real>& run(std::span<const Real> u, std::span<const Real> y,
                                  std::span<const Real> sp, int gain_sign = 0);
  /// The answer; meaningful when done.
  [[nodiscard]] const Identification<Real>& result() const { return result_; }
  /// Output of the two-path model over the window, units of y (free simulation).
  void simulate_two_path(std::span<Real> y) const;
  /// Output of the physical valve and its process over the window, units of y.
  void simulate_valve(std::span<Real> y);
  /// Stem position of the physical valve over the window, units of u.
  void stem_positions(std::span<Real> x) const;

 private:
  enum class Stage : unsigned char { kStructure, kValve, kIntervals, kDone };
  std::size_t size_ = 0;
  Stage stage_ = Stage::kDone;
  Identification<Real> result_;
};

}  // namespace ident
