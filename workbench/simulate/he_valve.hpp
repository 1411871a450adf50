// He's stick-slip valve: it moves in jumps.
#pragma once

#include "workbench/simulate/friction.hpp"
#include "workbench/simulate/valve.hpp"

namespace workbench {

/// The data-driven model of He, Wang, Pottmann & Qin (2007), one pair of
/// friction values per stroke. With r(t) = u(t) - x(t-1):
///   x(t) = u(t) - fd_asc   if r(t) >  fs_asc
///   x(t) = u(t) + fd_desc  if r(t) < -fs_desc
///   x(t) = x(t-1)          otherwise
/// After a jump the stem is at rest again, so a long stroke is a staircase.
/// fs = 5, fd = 0 is the valve of the paper's Example 5.1.
class HeValve final : public Valve {
 public:
  explicit HeValve(const Friction& friction) : friction_(friction) {}
  void rest(double u) override { x_ = u; }
  double step(double u) override {
    const double residual = u - x_;
    if (residual > friction_.static_ascending) {
      x_ = u - friction_.kinetic_ascending;
    } else if (residual < -friction_.static_descending) {
      x_ = u + friction_.kinetic_descending;
    }
    return x_;
  }

 private:
  Friction friction_;
  double x_ = 0;
};

}  // namespace workbench
