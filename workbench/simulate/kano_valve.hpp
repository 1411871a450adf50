// Kano's flow chart for a sticking valve, in S and J.
#pragma once

#include "workbench/simulate/valve.hpp"

namespace workbench {

/// Kano, Maruta, Kugemoto & Shimizu (2004), written as published: the stem
/// stopped at signal u_s after a stroke of direction d in {-1, +1} and moves
///   again the other way   when -d (u - u_s) > S,
///   on in the same way    when  d (u - u_s) > J,
/// to x = u - d (S - J) / 2, and stops when the signal stops or turns. The same
/// valve as SlidingValve with friction_from_s_j(S, J), by another route.
class KanoValve final : public Valve {
 public:
  /// `stick_band` S and `slip_jump` J in units of u, 0 <= J <= S.
  KanoValve(double stick_band, double slip_jump) : s_(stick_band), j_(slip_jump) {}
  /// Rests as after an upward stroke to x = u, that is with u_s = u + (S - J) / 2.
  void rest(double u) override {
    x_ = u;
    u_ = u;
    stopped_at_ = u + (s_ - j_) / 2;
    direction_ = 1;
    stopped_ = true;
  }
  double step(double u) override {
    if (!stopped_ && (u - u_) * direction_ <= 0) {
      stopped_ = true;
      stopped_at_ = u_;
    }
    if (stopped_) {
      const double travel = direction_ * (u - stopped_at_);
      if (-travel > s_) {
        direction_ = -direction_;
        stopped_ = false;
      } else if (travel > j_) {
        stopped_ = false;
      }
    }
    if (!stopped_) x_ = u - direction_ * (s_ - j_) / 2;
    u_ = u;
    return x_;
  }

 private:
  double s_;
  double j_;
  double x_ = 0;
  double u_ = 0;
  double stopped_at_ = 0;
  double direction_ = 1;
  bool stopped_ = true;
};

}  // namespace workbench
