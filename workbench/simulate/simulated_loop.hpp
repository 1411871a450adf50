// A simulated recording with its truth.
#pragma once

#include <vector>

#include "workbench/simulate/truth.hpp"

namespace workbench {

/// Signals of one loop at t = 0, period_s, 2 period_s, …; all of one length.
struct SimulatedLoop {
  double period_s = 1;
  std::vector<double> t;        ///< s
  std::vector<double> u;        ///< controller output
  std::vector<double> y;        ///< measured process output
  std::vector<double> sp;       ///< setpoint, units of y
  std::vector<double> x;        ///< valve position, units of u
  std::vector<double> y_clean;  ///< process output from x alone: no noise, no load
  LoopTruth truth;
};

}  // namespace workbench
