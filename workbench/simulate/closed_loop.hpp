// One feedback loop: PI controller, valve, process, disturbances.
#pragma once

#include <cstddef>
#include <vector>

#include "workbench/simulate/friction.hpp"
#include "workbench/simulate/pi_controller.hpp"
#include "workbench/simulate/process.hpp"
#include "workbench/simulate/valve.hpp"

namespace workbench {

/// Everything about a run but the valve. Signals shorter than the run are
/// continued with their last value; empty means 0.
struct LoopSetup {
  ProcessModel process;
  PiSettings controller;
  double period_s = 1;
  std::size_t warm_up = 0;          ///< samples simulated, then dropped
  std::size_t samples = 0;          ///< samples kept
  double rest_u = 0;                ///< u and x at the start; the process sees x - rest_u
  double input_bias = 0;            ///< constant added to the process input, units of u
  double positioner_lag_s = 0;      ///< lag between signal and valve, 0 = none
  double y_resolution = 0;          ///< y is rounded to multiples of it, 0 = off
  double u_resolution = 0;          ///< likewise u, before it reaches the valve
  Friction sensor;                  ///< of a sensor that sticks and jumps, units of y
  std::vector<double> setpoint;     ///< units of y
  std::vector<double> input_load;   ///< added to the process input, units of u
  std::vector<double> output_load;  ///< added to y, units of y
  std::vector<double> noise;        ///< measurement noise added to y, units of y
};

/// What a run leaves behind; all of the same length, without the warm-up.
struct Trajectory {
  std::vector<double> u, y, sp, x;
  std::vector<double> y_clean;  ///< the process driven by x and `input_bias` alone
};

/// Runs the loop. At instant t the process output is measured, the controller
/// answers with u(t), the valve moves to x(t), and x(t) is held until t + 1: the
/// input acts on the output one sample later at the earliest, plus the dead time.
[[nodiscard]] Trajectory run_loop(const LoopSetup& setup, Valve& valve);

}  // namespace workbench
