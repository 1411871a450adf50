// A step test whose recording begins with its step.
#pragma once

#include "workbench/recording/recording.hpp"

namespace workbench {

/// Puts a rest of kRestSamples in front of `recording`: u at `u_before`, all else as in
/// the first sample, settled; times before the first one. The recording has no pieces
/// yet. Its clock time is no longer known. Tells so in the notes. Throws
/// std::invalid_argument where u is absent, or begins at that value already.
inline constexpr std::size_t kRestSamples = 12;
void put_rest_before(Recording& recording, double u_before);

}  // namespace workbench
