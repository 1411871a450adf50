// When a level changed, whatever u did then.
#pragma once

#include <cstddef>
#include <vector>

#include "workbench/effects/situation.hpp"

namespace workbench {

/// (W13) The sample at which one change of level explains most of what neither the model
/// so far nor answers of other lags to u explain, on the estimation samples, and up to
/// two more at least a tenth of the record away; best first. A controller answers a load,
/// so that a model without it has bent its answer to u. O(samples).
[[nodiscard]] std::vector<std::size_t> level_changes(const Situation& situation);

}  // namespace workbench
