// Families of loops drawn from a seed: sticking valves, valves with play, healthy ones.
#pragma once

#include <cstdint>
#include <string_view>

#include "workbench/simulate/simulated_loop.hpp"

namespace workbench {

enum class Strokes {
  kEqual,     ///< one S and J
  kOneSided,  ///< one stroke sticks, the other follows the signal
  kMixed,     ///< both stick, S and J differ
};

/// A sticking loop drawn from the seed. Guaranteed, by drawing again: a regular
/// limit cycle that the same loop with a linear valve does not have, 5 to 40
/// cycles in 600 to 4000 samples, u swinging over at least 1.1 S, the amplitude
/// of y at least three standard deviations of the noise, and noise that alone
/// moves u by a quarter of S at most (standard deviation). In some recordings u is
/// cut off at a limit.
/// `level`: integrating processes only. `moving_setpoint`: steps or a smooth
/// motion on top; the limit cycle is then guaranteed at constant setpoint, and in
/// the recording the stem turns at least eight times.
[[nodiscard]] SimulatedLoop stiction_family(std::string_view scenario, std::uint64_t seed,
                                            Strokes strokes, bool level,
                                            bool moving_setpoint);

/// A loop whose valve has play but no slip jump. Play makes a limit cycle only where
/// process and controller both integrate (or nearly): such loops are half of the family.
/// In the other half a load or the setpoint moves a self-regulating loop over the gap,
/// which is 15 to 60 % of the swing of u. The play is seen: it moves y by at least 1.5
/// standard deviations of the noise, root mean square.
[[nodiscard]] SimulatedLoop backlash_family(std::string_view scenario,
                                            std::uint64_t seed);

/// A loop in 400 to 2000 samples of which the setpoint makes one to four steps, while a
/// load with a memory of 50 to 2000 samples moves u by 2 to 30 % of what the steps do.
/// `sticks`: its valve sticks with a band of 8 to 70 % of the movement of u, equal
/// strokes; else it follows its signal. Nothing promises that the data can tell.
[[nodiscard]] SimulatedLoop few_steps_family(std::string_view scenario,
                                             std::uint64_t seed, bool sticks);

// The others return kind no_stiction; all but tight_tuning settle by themselves.

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
