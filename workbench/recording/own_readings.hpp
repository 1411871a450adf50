// Columns that say of the loop what u, y and the setpoint say: no loads.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "workbench/recording/recording.hpp"

namespace workbench {

/// Whether a column of the loop explains the share `alike` of the variance of the load's
/// values: u, y, sp, x, or what a controller makes of its error (sp − y, or y without a
/// setpoint), its proportional, integral and derivative parts. Cost: some passes.
[[nodiscard]] bool is_own_reading(const Recording& recording, const Load& load,
                                  double alike);

/// Takes the loads out that are made of the loop's own columns (all but 10⁻⁴ of their
/// variance) but those named in `kept`; their names.
std::vector<std::string> take_out_own_readings(Recording& recording,
                                               std::span<const std::string> kept = {});

/// The same, and says so in the notes.
void leave_out_own_readings(Recording& recording, std::span<const std::string> kept = {});

}  // namespace workbench
