// Signals of a file that nobody asked for.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "workbench/recording/recording.hpp"

namespace workbench {

/// True of row numbers, counters and clocks: values that only rise, or only fall, from
/// end to end, or by equal steps from one value on again and again, as the time of a
/// batch does. A measured signal with its noise turns around. O(n log n).
[[nodiscard]] bool is_count(std::span<const double> values);

/// Names of the loads that may move the output: those that move, less counts and what
/// their names say is only wanted, setpoints and deviations.
[[nodiscard]] std::vector<std::string> names_of_moving(const std::vector<Load>& loads);

/// "a, b, c and 2 more"
[[nodiscard]] std::string first_three(const std::vector<std::string>& names);

}  // namespace workbench
