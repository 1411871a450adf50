// What there is to say of the signals of a recording before anything is identified.
#pragma once

#include <string>
#include <vector>

#include "workbench/recording/recording_view.hpp"

namespace workbench {

/// One sentence each: a signal that never moves, a controller output that rests at its
/// own limit (output_limit.hpp), two signals that move in the same sample. O(samples).
[[nodiscard]] std::vector<std::string> signal_notes(const RecordingView& recording);

}  // namespace workbench
