// What there is to say of the signals of a recording before anything is identified.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "workbench/recording/recording_view.hpp"

namespace workbench {

/// One sentence each: a signal that never moves, a controller output that rests at its
/// own limit (output_limit.hpp). O(samples).
[[nodiscard]] std::vector<std::string> signal_notes(const RecordingView& recording);

/// Whether u and y, or u and the y after it, are one signal on two scales: a controller
/// without integral action that takes over nothing else, from which nothing is learnt of
/// what the valve makes of u; or no loop at all. O(samples).
[[nodiscard]] bool is_one_signal(std::span<const double> u, std::span<const double> y);

/// Of a recording that leaves the valve open: that y moves with u in the same sample, in
/// which no model of u alone can say which of them comes first; else "". O(samples).
[[nodiscard]] std::string same_sample_note(const RecordingView& recording);

/// Of a recording that a model takes as one and answers from u: where it may have been
/// joined (longest_part.hpp), and the above. Cost: some ten passes.
[[nodiscard]] std::vector<std::string> notes_for_model(const RecordingView& recording);

}  // namespace workbench
