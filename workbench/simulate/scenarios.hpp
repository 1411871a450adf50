// The simulator's front door: a scenario's name and a seed make a recording.
//
// simulate("stiction", 7) always returns the same recording. Families draw
// everything from the seed: process, tuning, noise, valve, units, length. Cost:
// a few milliseconds, up to some hundred where a family has to redraw. No global
// state; calls from several threads do not meet.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "workbench/simulate/simulated_loop.hpp"

namespace workbench {

struct ScenarioInfo {
  std::string_view name;
  std::string_view description;  ///< one line
};

/// All scenarios, in the order in which they should be listed.
[[nodiscard]] std::span<const ScenarioInfo> scenarios();

/// The recording of a scenario; nothing where no scenario has this name. Throws
/// std::runtime_error if a family finds no loop within 5000 redraws; no such seed
/// is known.
[[nodiscard]] std::optional<SimulatedLoop> simulate(std::string_view scenario,
                                                    std::uint64_t seed);

}  // namespace workbench
