// The loop's controller.
#pragma once

namespace workbench {

/// C(s) = gain (1 + 1 / (reset_time s)).
struct PiSettings {
  double gain = 1;          ///< units of u per unit of y; its sign is the process gain's
  double reset_time_s = 1;  ///< > 0
  double low = -1e300;      ///< lower limit of u
  double high = 1e300;      ///< upper limit of u
  double gap = 0;           ///< gap action: no control while |sp - y| <= gap; 0 = off
};

/// PI controller in velocity form, backward difference of the integral, with
/// e = sp - y:
///   u(t) = clip(u(t-1) + gain [e(t) - e(t-1) + period / reset_time · e(t)]).
/// Clipping u itself is its anti-windup. With gap action e is what sp - y has beyond
/// the gap, 0 inside.
class PiController {
 public:
  /// `start`: u before the first sample, bumpless with e = 0.
  PiController(const PiSettings& settings, double period_s, double start);
  /// The controller output for this sample's setpoint and measurement.
  double step(double setpoint, double measurement);

 private:
  PiSettings settings_;
  double integral_gain_;
  double u_;
  double error_ = 0;
};

}  // namespace workbench
