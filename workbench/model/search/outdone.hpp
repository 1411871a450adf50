// What explains far more, but moves too seldom to be told.
#pragma once

#include <vector>

#include "workbench/model/search/trial.hpp"

namespace workbench {

/// Leaves each accepted effect undecided beside which another one leaves less than a
/// quarter of the squared error on samples that were not fitted, and less on the others,
/// too, and is open only because the recording exercises it too seldom: the same few
/// moves that name the one would name the other. Not one that its own test shows.
/// Concluded trials.
void leave_outdone_open(std::vector<Trial>& trials);

}  // namespace workbench
