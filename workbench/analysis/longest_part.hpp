// Where a recording was joined from several, and the longest part of it that was not.
#pragma once

#include <cstddef>

#include "workbench/recording/recording_view.hpp"

namespace workbench {

/// A stretch of a recording.
struct UncutPart {
  std::size_t first = 0;    ///< sample
  std::size_t length = 0;   ///< samples, at least 1
  std::size_t seam_at = 0;  ///< first sample after the clearest seam; 0: none was found
};

/// Cuts at the seams (ident/signal/seam.hpp) that stand out, then at those that stand out
/// in what is left, until none does or what would be left is too short to be identified.
/// Cost: some ten passes a cut.
[[nodiscard]] UncutPart longest_part(const RecordingView& recording);

/// The samples of `part` alone; the name and all else stay.
[[nodiscard]] Recording cut_out(const Recording& recording, const UncutPart& part);

}  // namespace workbench
