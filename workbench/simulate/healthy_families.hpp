// Families of loops that move or oscillate although their valve is fine.
#pragma once

#include <cstdint>
#include <string_view>

#include "workbench/simulate/simulated_loop.hpp"

namespace workbench {

// All return kind no_stiction. Loops other than tight_tuning settle by themselves.

/// A sinusoid acts on the process input or output, 5 to 40 periods, in half of
/// the recordings with a period that wanders by up to 6 %.
[[nodiscard]] SimulatedLoop external_sinusoid(std::string_view scenario,
                                              std::uint64_t seed);

/// The controller gain is 0.85 to 0.98 of the critical one and noise and load keep
/// the loop ringing, or 1.02 to 1.4 of it and u cycles between its limits.
[[nodiscard]] SimulatedLoop tight_tuning(std::string_view scenario, std::uint64_t seed);

/// First-order coloured load, up to nearly a random walk.
[[nodiscard]] SimulatedLoop random_load(std::string_view scenario, std::uint64_t seed);

/// Coloured load, load steps, a slow drift and strong noise together.
[[nodiscard]] SimulatedLoop load_and_noise(std::string_view scenario, std::uint64_t seed);

/// The setpoint moves: steps, ramps, or smoothly as the inner loop of a cascade.
[[nodiscard]] SimulatedLoop setpoint_moves(std::string_view scenario, std::uint64_t seed);

/// Nothing but measurement noise.
[[nodiscard]] SimulatedLoop noise_only(std::string_view scenario, std::uint64_t seed);

/// y, u or both come in 4 to 25 steps over their swing, inside the loop; a load
/// or the setpoint moves them.
[[nodiscard]] SimulatedLoop quantised(std::string_view scenario, std::uint64_t seed);

/// A positioner as they are: hysteresis of 0.2 to 0.5 % of the swing of u and a
/// lag. The truth states that band, the verdict ought to be no_stiction; the
/// cause is what moves the loop.
[[nodiscard]] SimulatedLoop healthy_positioner(std::string_view scenario,
                                               std::uint64_t seed);

}  // namespace workbench
