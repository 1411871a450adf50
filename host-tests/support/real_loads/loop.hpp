// Closed loops under real loads, seen through a historian: harder than the scenarios of
// workbench/simulate, with a truth that recordings do not have.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "support/real_loads/loads.hpp"
#include "support/workbench/historian.hpp"
#include "workbench/simulate/simulated_loop.hpp"

namespace workbench::test {

/// A sticking loop counts only if an oracle that sees the stem is sure, nats.
inline constexpr double kLeastOracleNats = 40;

enum class LoopKind {
  kSticking,  ///< the valve sticks, or has backlash behind tight tuning
  kHealthy,   ///< the valve follows u; something else moves the loop
};

/// What a loop is known to contain beside the truth of any simulated loop.
struct RealLoadTruth {
  /// kSticking: slides, stops, resticks or backlash. kHealthy: none.
  std::string motion = "none";
  std::string strokes = "none";  ///< equal, different or one_sided; none where healthy
  Historian historian = Historian::kNone;
  std::string load;            ///< name of the recording the load is cut from
  std::string load_at;         ///< input or output of the process
  double load_share = 0;       ///< size of the load over that of what else moves the loop
  std::string setpoint;        ///< constant, few_moves, step_test or moving
  double gap = 0;              ///< of gap action, units of y; 0 without
  double cycles = 0;           ///< of u in the recording
  double band_over_swing = 0;  ///< larger stick band over the usual swing of u in a cycle
  /// The less of two: against the recorded u, and against u before the historian, so
  /// that what the historian took from u does not count for the stem. See oracle_nats.
  double oracle_nats = 0;
};

struct RealLoadLoop {
  SimulatedLoop recorded;  ///< u and y through the historian; truth as simulated
  RealLoadTruth truth;
};

/// Draws loops until one is stable and moves: 600 to 4000 samples; u with 5 to 60 cycles
/// of 8 to 80 samples unless only the setpoint or a drift moves it; an oracle that is
/// sure where the valve sticks. Motion, cause, historian and kind of process are drawn
/// once, so that rare combinations do not vanish. The same seed and recordings give the
/// same loop. Causes of healthy loops: tight_tuning, load, setpoint, sinusoid, neighbour
/// (the output of a loop that sticks), drift, sensor (sticks and jumps). Takes 0.02 to 2
/// s. Throws std::runtime_error where the ranges leave no loop, std::invalid_argument
/// without loads.
[[nodiscard]] RealLoadLoop real_load_loop(LoopKind kind, std::uint64_t seed,
                                          const std::vector<RealLoad>& loads);

/// All that is known of the loop.
[[nodiscard]] nlohmann::json truth_json(const RealLoadLoop& loop);

}  // namespace workbench::test
