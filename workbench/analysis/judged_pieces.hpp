// The pieces of a recording between its long gaps that can be judged.
#pragma once

#include <string>
#include <vector>

#include "workbench/recording/recording_view.hpp"

namespace workbench {

struct JudgedPieces {
  std::vector<RecordingView> pieces;  ///< at least one, in the order of time
  std::vector<std::string> notes;     ///< one sentence each; none without a gap
};

/// Cuts at the long gaps (recording/long_gaps.hpp): what the loop did meanwhile is not
/// known. Pieces shorter than a tenth of the longest, or than a window may be, say
/// nothing and are left out, the longest aside. Without gaps it is all one piece.
[[nodiscard]] JudgedPieces judged_pieces(const RecordingView& recording);

}  // namespace workbench
