// Loops that see little: one to four setpoint steps and a wandering load.
#pragma once

#include <cstdint>
#include <string_view>

#include "workbench/simulate/simulated_loop.hpp"

namespace workbench {

/// A loop in 400 to 2000 samples of which the setpoint makes one to four steps, while a
/// load with a memory of 50 to 2000 samples moves u by 2 to 30 % of what the steps do.
/// `sticks`: its valve sticks with a band of 8 to 70 % of the movement of u, equal
/// strokes; else it follows its signal. Nothing promises that the data can tell.
[[nodiscard]] SimulatedLoop few_steps_family(std::string_view scenario,
                                             std::uint64_t seed, bool sticks);

}  // namespace workbench
