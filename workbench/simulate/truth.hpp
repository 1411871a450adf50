// What a simulated recording is known to contain.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "workbench/simulate/friction.hpp"
#include "workbench/simulate/pi_controller.hpp"
#include "workbench/simulate/process.hpp"

namespace workbench {

/// The valve behind a recording, in the recording's units of u.
struct ValveTruth {
  std::string model = "linear";  ///< linear, backlash, he (moves in jumps), sliding,
                                 ///< coasting
  Friction friction;             ///< its forces; 0 for a linear valve
  double positioner_lag_s = 0;   ///< lag between signal and stem, 0 = none
};

/// The truth of a recording, in its own units.
struct LoopTruth {
  std::string scenario;
  std::uint64_t seed = 0;
  /// What the verdict ought to be: stiction, backlash or no_stiction. A recording
  /// that never moves the valve enough may rightly be called undecided.
  std::string kind;
  /// Why the loop moves: stiction, backlash, external_sinusoid, tight_tuning,
  /// random_load, setpoint, healthy (noise alone) or quantised.
  std::string cause;
  double stick_band_ascending = 0;  ///< S, units of u; 0 where the stroke does not stick
  double stick_band_descending = 0;
  double slip_jump_ascending = 0;  ///< J, units of u; 0 for backlash
  double slip_jump_descending = 0;
  ValveTruth valve;
  ProcessModel process;
  PiSettings controller;
  bool u_limited = false;  ///< u touches a limit of the controller
  double noise_std = 0;    ///< of the measurement noise, units of y
  /// Fit of the true valve position through the true process. Far below 0 where a
  /// load moves y, since the load has no part in it.
  double noise_ceiling_percent = 0;
  double oscillation_period_s = 0;  ///< mean period where the loop oscillates, else 0
};

/// The contract's fit, 100 (1 - |y_clean - y| / |y - mean(y)|), in percent.
/// Same lengths, at least one sample; NaN where y is constant.
[[nodiscard]] double noise_ceiling_percent(std::span<const double> y,
                                           std::span<const double> y_clean);

[[nodiscard]] nlohmann::json truth_json(const LoopTruth& truth);

}  // namespace workbench
