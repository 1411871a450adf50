// Signals of a file that nobody asked for.
#pragma once

#include <string>
#include <vector>

#include "workbench/recording/recording.hpp"

namespace workbench {

/// Names of the loads that may move the output: those that move, less what their names
/// say is only wanted, setpoints and deviations.
[[nodiscard]] std::vector<std::string> names_of_moving(const std::vector<Load>& loads);

/// "a, b, c and 2 more"
[[nodiscard]] std::string first_three(const std::vector<std::string>& names);

}  // namespace workbench
