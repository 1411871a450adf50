// What there is to say of the signals of a recording before anything is identified.
#pragma once

#include <string>
#include <vector>

#include "workbench/recording/recording_view.hpp"

namespace workbench {

/// One sentence each: a signal that never moves, a controller output that rests at its
/// own limit (output_limit.hpp). O(samples).
[[nodiscard]] std::vector<std::string> signal_notes(const RecordingView& recording);

/// Of a recording that leaves the valve open: that y moves with u in the same sample, in
/// which no model of u alone can say which of them comes first; else "". O(samples).
[[nodiscard]] std::string same_sample_note(const RecordingView& recording);

}  // namespace workbench
