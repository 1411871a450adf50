// What of a recording was recorded in one go.
#pragma once

#include <vector>

#include "workbench/recording/recording.hpp"

namespace workbench {

/// The stretches of its pieces between what is left out, in the order of time; those ten
/// times shorter than the longest say nothing and are dropped. A recording in one go
/// comes back as it is.
[[nodiscard]] std::vector<Recording> uncut_parts(const Recording& recording);

/// True where nothing is left out and there is no pause.
[[nodiscard]] bool in_one_go(const Recording& recording);

}  // namespace workbench
