// The value in the middle.
#pragma once

#include <vector>

namespace workbench {

/// Of at least one value; of an even count the mean of the two in the middle. O(n).
[[nodiscard]] double median(std::vector<double> values);

}  // namespace workbench
