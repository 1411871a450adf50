#include "workbench/simulate/pi_controller.hpp"

#include <algorithm>

namespace workbench {

PiController::PiController(const PiSettings& settings, double period_s, double start)
    : settings_(settings),
      integral_gain_(settings.gain * period_s / settings.reset_time_s),
      u_(start) {}

double PiController::step(double setpoint, double measurement) {
  const double error = setpoint - measurement;
  u_ += settings_.gain * (error - error_) + integral_gain_ * error;
  u_ = std::clamp(u_, settings_.low, settings_.high);
  error_ = error;
  return u_;
}

}  // namespace workbench
