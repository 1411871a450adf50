// Recordings that do not behave like the others they were fitted with.
#pragma once

#include <string>
#include <vector>

#include "workbench/model/judge/quality.hpp"

namespace workbench {

/// A file that a first-order process of its own explains far better than the model that
/// it shares with others. Contract's fit, %.
struct Unlike {
  std::string file;
  double fit_alone = 0;
  double fit_shared = 0;
};

/// Of `joined` (joined.hpp), with `shared` as what the common model makes of each file:
/// those of which a process of their own leaves less than half the error. They are of
/// another loop, or of one whose range, units or load were changed. Empty for a single
/// file. Costs one first fit for each.
[[nodiscard]] std::vector<Unlike> unlike(const Recording& joined, Column output,
                                         const std::vector<RecordingFit>& shared);

}  // namespace workbench
