// Families of loops that oscillate because their valve sticks.
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

}  // namespace workbench
