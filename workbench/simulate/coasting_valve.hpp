// A sticking valve that needs nothing to go on once it is free.
#pragma once

#include "workbench/simulate/friction.hpp"
#include "workbench/simulate/valve.hpp"

namespace workbench {

/// Sticks like SlidingValve at a reversal, but goes on in the direction of its last move
/// without friction, however often the signal stops or retreats a little:
///   after an upward move  x(t) = u(t) - fd_asc if that is more than x(t-1), and turns
///                         when u - x < -fs_desc; the mirror image after a downward one
///   at the start          as SlidingValve at rest.
class CoastingValve final : public Valve {
 public:
  explicit CoastingValve(const Friction& friction) : friction_(friction) {}
  void rest(double u) override {
    x_ = u;
    direction_ = 0;
  }
  double step(double u) override {
    const double up =
        direction_ > 0 ? friction_.kinetic_ascending : friction_.static_ascending;
    const double down =
        direction_ < 0 ? friction_.kinetic_descending : friction_.static_descending;
    if (u - x_ > up) {
      direction_ = 1;
      x_ = u - friction_.kinetic_ascending;
    } else if (u - x_ < -down) {
      direction_ = -1;
      x_ = u + friction_.kinetic_descending;
    }
    return x_;
  }

 private:
  Friction friction_;
  double x_ = 0;
  int direction_ = 0;  // of the last move, 0 before the first
};

}  // namespace workbench
