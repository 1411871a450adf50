// The closed loop of the hidden-effect benchmark: a controller sampled once a period
// around the continuous valve and process, which advance in `sub_steps` steps a period.
// Shares no code with the fitted models or with `stickband simulate`.
//
// Sample k: y is measured at t_k, the controller computes u from it, and u is held until
// t_(k+1). The controller sees what is recorded, noise and quantisation included.
#pragma once

#include <cstddef>
#include <vector>

#include "support/hidden/process.hpp"
#include "support/hidden/valve.hpp"

namespace hidden {

enum class ControllerKind {
  kPi,
  kOnOff,     ///< relay with hysteresis between two values of u
  kFloating,  ///< u rises or falls at a constant rate, turned round with hysteresis
};

struct ControllerSettings {
  ControllerKind kind = ControllerKind::kPi;
  double gain = 0;           ///< u/y; its sign is the action of every kind
  double reset_s = 1;        ///< PI
  double hysteresis = 0;     ///< relay, floating: turned round at setpoint ± this; y
  double centre_offset = 0;  ///< relay: middle of the two values less rest_u; u
  double swing = 0;          ///< relay: half the distance of the two values; u
  double ramp_rate = 0;      ///< floating; u/s
  double low = 0;            ///< limits of u
  double high = 100;
};

/// Loads at the input of the process, in units of u; times count from the first
/// recorded sample. No load before it, but for the sinusoid.
struct Loads {
  double sinusoid = 0;  ///< amplitude
  double sinusoid_period_s = 1;
  double sinusoid_phase = 0;  ///< rad
  double step = 0;
  double step_at_s = 0;
  double ramp = 0;  ///< reached at the end of the recording
  double ramp_from_s = 0;
};

struct LoopSetup {
  double period_s = 1;
  int sub_steps = 20;
  std::size_t warm_up = 0;  ///< samples run before the first recorded one
  std::size_t samples = 0;  ///< recorded
  double rest_u = 50;
  double rest_y = 0;
  ValvePhysics valve;
  ProcessPhysics process;
  Loads loads;
  double quantum = 0;          ///< resolution of the recorded y; 0 for none
  double sticking_band = 0;    ///< the reading follows what is further off than this
  std::vector<double> spikes;  ///< added to single readings; may be absent
  double reading_low = -kUnlimited;  ///< ends of the range of the sensor; y
  double reading_high = kUnlimited;
  double compression = 0;     ///< tolerance of the historian; 0 for none
  bool holds_stored = false;  ///< it holds what it stored; else straight lines
  double noise_std = 0;       ///< of the measurement, before the quantisation; y
  ControllerSettings controller;
  /// Deviation from rest_y and standard normal draws, one for each sample, warm-up
  /// included; noise may be absent.
  std::vector<double> setpoint;
  std::vector<double> noise;
};

/// All signals have warm_up + samples values.
struct Trace {
  std::vector<double> u;
  std::vector<double> y;       ///< recorded; the controller sees it before the historian
  std::vector<double> sensed;  ///< y before noise and quantisation
  std::vector<double> sp;
  std::vector<double> stem;  ///< at the end of the period that starts at the sample
  // Of the recorded samples:
  ValveEvents valve;
  int rate_limited = 0;  ///< moves that the rate limit had not let through a period later
  int overflows = 0;
  int cut_off = 0;
  bool ran_dry = false;  ///< HiddenProcess::ran_dry(), the warm-up included
};

/// Runs the loop; with `imposed_u` the same plant in open loop.
[[nodiscard]] Trace run_loop(const LoopSetup& setup,
                             const std::vector<double>* imposed_u = nullptr);

/// The recorded samples of one signal of the trace.
[[nodiscard]] std::vector<double> recorded(const LoopSetup& setup,
                                           const std::vector<double>& signal);

}  // namespace hidden
