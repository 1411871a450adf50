// How far the valve's parameters can be moved before the data object.
#pragma once

#include "ident/valve/valve_search.hpp"

namespace ident {

/// Bounds of the four quantities that are reported, scaled like u.
template <class Real>
struct ValveIntervals {
  struct Bounds {
    Real low = 0;
    Real high = 0;
  };
  Bounds stick_ascending;
  Bounds stick_descending;
  Bounds slip_ascending;
  Bounds slip_descending;
};

/// Likelihood region of a fitted valve: from the best model, the largest step in each of
/// a set of directions (single parameters, trades of deadband against slip, time
/// constants following) after which the simulation error is still below `limit`; the
/// bounds enclose all of these points. Widths are calibrated on simulated loops
/// (docs/model.md, (I1)). Stops after any piece of a pass. Bounds: kDirections · 2 ·
/// kHalvings passes.
template <class Real>
class IntervalSearch {
 public:
  static constexpr int kDirections = 9;
  static constexpr int kHalvings = 7;

  /// Starts around `model` on the search's window; `limit` > the model's error. No bound
  /// is nearer to a value than `margin`: between two slips that fall on the same samples
  /// the error is flat, and a residual that is not white says that the model is not the
  /// valve.
  void start(const ValveModel<Real>& model, Real limit, Real swing, Real margin);
  /// Takes another model into the bounds, if its error is below the limit.
  void include(const ValveModel<Real>& model);
  /// Goes on by about `budget` units; true when done.
  bool step(ValveSearch<Real>& search, int budget);
  [[nodiscard]] const ValveIntervals<Real>& intervals() const { return intervals_; }

 private:
  void widen(const ValveFriction<Real>& friction);
  [[nodiscard]] Real first_step() const;
  [[nodiscard]] ValveModel<Real> trial() const;
  void take(const ValveModel<Real>& model);

  ValveModel<Real> best_;
  ValveIntervals<Real> intervals_;
  Real limit_ = 0;
  Real swing_ = 1;
  Real reach_ = 0;     // of the present direction: inside so far
  Real outside_ = 0;   // known to be outside, 0: none yet
  Real trial_ = 0;     // that is evaluated
  int direction_ = 0;  // two senses each
  int halving_ = 0;
  bool asked_ = false;  // the pass is the trial's
};

}  // namespace ident
