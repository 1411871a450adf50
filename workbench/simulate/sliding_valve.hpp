// A sticking valve that slides once it is free.
#pragma once

#include "workbench/simulate/friction.hpp"
#include "workbench/simulate/valve.hpp"

namespace workbench {

/// Sticks like HeValve, then slides with the signal until the signal turns:
///   at rest  x(t) = x(t-1), starts up when u - x > fs_asc, down when u - x < -fs_desc
///   sliding  x(t) = u(t) - fd_asc upwards, u(t) + fd_desc downwards
///   a sample that does not continue the slide puts the stem at rest.
/// For equal strokes this is Choudhury's (2005) valve with Kano's (2004) way of
/// remembering where it stopped: S to move after a reversal, J to move on in the
/// same direction.
class SlidingValve final : public Valve {
 public:
  explicit SlidingValve(const Friction& friction) : friction_(friction) {}
  void rest(double u) override {
    x_ = u;
    u_ = u;
    motion_ = 0;
  }
  double step(double u) override {
    const bool continues = motion_ > 0 ? u > u_ : motion_ < 0 && u < u_;
    if (!continues) motion_ = 0;
    if (motion_ == 0) {
      if (u - x_ > friction_.static_ascending)
        motion_ = 1;
      else if (u - x_ < -friction_.static_descending)
        motion_ = -1;
    }
    if (motion_ > 0) x_ = u - friction_.kinetic_ascending;
    if (motion_ < 0) x_ = u + friction_.kinetic_descending;
    u_ = u;
    return x_;
  }

 private:
  Friction friction_;
  double x_ = 0;
  double u_ = 0;
  int motion_ = 0;  // +1 sliding up, -1 sliding down, 0 at rest
};

}  // namespace workbench
