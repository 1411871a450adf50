// Where a recording of a limit cycle still runs up to it.
#pragma once

#include <cstddef>
#include <span>

namespace workbench {

/// First sample from which u only oscillates, 0 for a recording without a start-up. A
/// start-up ends before the middle of the recording, moves u several times as far as the
/// second half does, and that half oscillates regularly, y not running away in a straight
/// line; a recording of setpoint steps has none. Equal lengths. O(samples).
[[nodiscard]] std::size_t start_up_end(std::span<const double> u,
                                       std::span<const double> y);

}  // namespace workbench
