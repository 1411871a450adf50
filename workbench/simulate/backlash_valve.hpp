// Play between signal and stem.
#pragma once

#include <algorithm>

#include "workbench/simulate/valve.hpp"

namespace workbench {

/// Pure deadband of width D, the play operator:
///   x(t) = min(u(t) + D/2, max(u(t) - D/2, x(t-1))).
/// Stick band S = D for both strokes, slip jump J = 0.
class BacklashValve final : public Valve {
 public:
  /// `deadband` D >= 0, in units of u.
  explicit BacklashValve(double deadband) : half_(deadband / 2) {}
  void rest(double u) override { x_ = u; }
  double step(double u) override {
    x_ = std::min(u + half_, std::max(u - half_, x_));
    return x_;
  }

 private:
  double half_;
  double x_ = 0;
};

}  // namespace workbench
