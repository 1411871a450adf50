#include "workbench/simulate/pi_controller.hpp"

#include <algorithm>
#include <cmath>

namespace workbench {

PiController::PiController(const PiSettings& settings, double period_s, double start)
    : settings_(settings),
      integral_gain_(settings.gain * period_s / settings.reset_time_s),
      u_(start) {}

double PiController::step(double setpoint, double measurement) {
  double error = setpoint - measurement;
  if (settings_.gap > 0) {
    error = std::copysign(std::max(std::abs(error) - settings_.gap, 0.0), error);
  }
  u_ += settings_.gain * (error - error_) + integral_gain_ * error;
  u_ = std::clamp(u_, settings_.low, settings_.high);
  error_ = error;
  return u_;
}

}  // namespace workbench
