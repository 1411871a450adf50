// Whether u and y were recorded at the same time.
#pragma once

#include <string>

#include "workbench/recording/recording_view.hpp"

namespace workbench {

/// By how many samples y is recorded later than what the controller read when it computed
/// the u beside it; below 0: u is recorded later; 0 where the recording does not tell. A
/// controller answers what it reads within the sample, by its law (ControllerAction), so
/// the law is sharpest where both stand beside one another. Told where it leaves half of
/// what it leaves of the recording as it is, or less. Of a y that is late u foretells the
/// next value better than any valve does: it was computed from it. O(samples).
[[nodiscard]] int samples_late(const RecordingView& recording);

/// The same recording with y, or below 0 with u, moved back by so many samples; the ends
/// that have no partner go.
[[nodiscard]] RecordingView aligned(const RecordingView& recording, int late);

/// What there is to say of that; `late` is not 0.
[[nodiscard]] std::string alignment_note(int late);

}  // namespace workbench
