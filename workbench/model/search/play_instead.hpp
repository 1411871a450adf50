// Play in the place of stiction.
#pragma once

#include <vector>

#include "workbench/model/search/trial.hpp"

namespace workbench {

/// (W32) For the accepted trial with stiction that leaves least, alone or with one more
/// effect: the same with backlash instead, and with dead time, a second lag or a process
/// that integrates: of those that leave least the first that passes. A stem that slides
/// for a while, or slips a little, does what one that does not slip does in front of
/// them. Kept only where it scores better (merit.hpp), than stiction in front of the
/// same, too, and each_is_needed(); as examined. Empty where no such trial is. Cost: some
/// seven screenings, and three thorough searches.
[[nodiscard]] std::vector<Trial> play_instead(const Fitter& fitter, const Fit& base,
                                              const std::vector<Trial>& trials);

}  // namespace workbench
