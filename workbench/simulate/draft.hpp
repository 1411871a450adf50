// A loop while a scenario is still being drawn.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/simulate/closed_loop.hpp"
#include "workbench/simulate/friction.hpp"
#include "workbench/simulate/random.hpp"
#include "workbench/simulate/simulated_loop.hpp"

namespace workbench {

/// Drafts of a recording until one is as its scenario wants it.
inline constexpr int kMostRedraws = 5000;

enum class LoopType {
  kFlow,   ///< time constants of a few samples, PI with the integral dominant
  kSlow,   ///< self-regulating, time constants of many samples
  kLevel,  ///< integrating
};

/// A loop in drafting units: u in percent, y in percent times the process gain.
struct Draft {
  LoopSetup setup;
  std::string valve_model = "linear";  ///< linear, backlash, he, sliding, coasting
  Friction friction;                   ///< of the valve; a backlash is 2 fd wide
  double noise_std = 0;                ///< of setup.noise
};

/// Scale and offset from drafting units to those of the recording.
struct Units {
  double u_scale = 1;  ///< > 0
  double u_offset = 0;
  double y_scale = 1;  ///< > 0
  double y_offset = 0;
};

/// Draws sample period, process and controller; signals, lengths and valve are
/// left alone. The tuning is meant to be sound, but nothing is promised.
void draw_loop(Random& random, LoopType type, Draft& draft);

/// Flow loops matter most: one half; a third slow, the rest level.
[[nodiscard]] LoopType draw_loop_type(Random& random);

/// Measurement noise of the given standard deviation for `samples` samples,
/// white or coloured.
void draw_noise(Random& random, std::size_t samples, double std, Draft& draft);

/// Units of which `swing` of drafting y becomes 0.5 to 500.
[[nodiscard]] Units draw_units(Random& random, double swing);

[[nodiscard]] std::unique_ptr<Valve> make_valve(const Draft& draft);
[[nodiscard]] Trajectory run_draft(const Draft& draft);
[[nodiscard]] Trajectory run_with_linear_valve(const Draft& draft);

void scale(std::vector<double>& signal, double factor);

/// How far u swings with a linear valve and no limits.
[[nodiscard]] double free_swing(Draft draft);

/// True if the loop with a linear valve answers a setpoint step with less than
/// 70 % overshoot and settles.
[[nodiscard]] bool settles(const Draft& draft);

/// How fast the loop rings with a linear valve, no limits and `gain_factor` times the
/// gain: size of a late stretch over that of an earlier one, 600 samples apart. Below 1
/// it dies out.
[[nodiscard]] double ringing_growth(const Draft& draft, double gain_factor);

/// Throws std::runtime_error: after all redraws there is none.
[[noreturn]] void no_loop(std::string_view scenario, std::uint64_t seed);

/// The recording in its own units, with the truth filled in but for the period
/// of the oscillation.
[[nodiscard]] SimulatedLoop finish(const Draft& draft, Trajectory run, const Units& units,
                                   std::string_view scenario, std::uint64_t seed,
                                   std::string_view kind, std::string_view cause);

}  // namespace workbench
