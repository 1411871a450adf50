// A simulated loop as a recording file.
#pragma once

#include <iosfwd>

#include "workbench/simulate/simulated_loop.hpp"

namespace workbench {

/// Writes `t,u,y,sp,x` with a header row, comma-separated; `x` only if
/// `with_position`. Numbers have as many digits as it takes to read the same
/// values back. The stream's own state tells whether writing worked.
void write_csv(const SimulatedLoop& loop, std::ostream& out, bool with_position = true);

}  // namespace workbench
