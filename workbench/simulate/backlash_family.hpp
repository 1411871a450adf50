// Loops whose valve has play but no slip jump.
#pragma once

#include <cstdint>
#include <string_view>

#include "workbench/simulate/simulated_loop.hpp"

namespace workbench {

/// Play makes a limit cycle only where process and controller both integrate (or
/// nearly): such loops are half of the family. In the other half a load or the
/// setpoint moves a self-regulating loop over the gap, which is 15 to 60 % of the
/// swing of u. The play is seen: it moves y by at least 1.5 standard deviations
/// of the noise, root mean square.
[[nodiscard]] SimulatedLoop backlash_family(std::string_view scenario,
                                            std::uint64_t seed);

}  // namespace workbench
