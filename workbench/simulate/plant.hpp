// A plant: loops that share headers and heat, some with valves that stick.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace workbench {

struct PlantOptions {
  int loops = 20;     ///< in all; areas of kLoopsPerArea
  int sticking = -1;  ///< valves that stick, at most one an area; −1: one an area
  std::uint64_t seed = 1;
  std::size_t samples = 4000;
};

inline constexpr int kLoopsPerArea = 20;
/// Neighbours that a sticking valve shakes (fewer in an area of fewer than six loops).
inline constexpr int kShaken = 5;

/// One loop as recorded, and what is true about it.
struct PlantLoop {
  std::string tag;  ///< FIC-101, TIC-102, LIC-103
  std::vector<double> u, y, sp;
  std::string cause;      ///< stiction, neighbour, tight_tuning, load, setpoint, noise
  std::string leader;     ///< tag of the valve that shakes it; "" none
  double stick_band = 0;  ///< units of u, 0: the valve follows its signal
  double slip_jump = 0;
  double compressed = 0;  ///< exception deviation of the historian, % of span; 0 none
  bool bad = false;       ///< its PV tag says Bad most of the time
};

struct PlantArea {
  int number = 1;
  double period_s = 5;
  std::vector<PlantLoop> loops;
  /// Tags of no loop, measured beside them.
  std::vector<std::pair<std::string, std::vector<double>>> indicators;
};

/// Area `number` (from 1) of the plant. The loops of an area hang on one header: flows
/// draw on it, and its pressure moves them; the temperature loops are heated by one
/// stream. All have noise and loads of their own and one common load of the header; some
/// setpoints move, now and then one is tuned too tight. Where a valve sticks, its limit
/// cycle, which it would have alone, reaches kShaken neighbours through the header with
/// two to six times their noise. A third of the loops is stored by exception, one in
/// thirty has a bad tag. The same options make the same plant.
[[nodiscard]] PlantArea simulate_area(const PlantOptions& options, int number);

[[nodiscard]] int areas_of(const PlantOptions& options);

/// A wide export: `Timestamp,FIC-101.OP,FIC-101.PV,FIC-101.SP,...`, with dates.
[[nodiscard]] std::string area_csv(const PlantArea& area);
/// One loop of it as a recording with the columns Timestamp, OP, PV, SP.
[[nodiscard]] std::string loop_csv(const PlantArea& area, const PlantLoop& loop);

/// What is true about the loops of an area, for TRUTH.json.
[[nodiscard]] nlohmann::ordered_json truth_json(const PlantArea& area);

}  // namespace workbench
