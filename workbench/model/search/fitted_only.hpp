// What only the fitted samples show.
#pragma once

#include <vector>

#include "workbench/model/search/trial.hpp"

namespace workbench {

/// Where no trial is accepted or undecided, leaves undecided the one that leaves least
/// over all samples, if it takes away half of the squared error on the fitted ones and
/// the others, which hardly show it, do not speak against it: only another recording, or
/// another split, tells it from chance. Rejected ones only, each concluded.
void leave_fitted_only_open(const Fitter& fitter, const Fit& base,
                            std::vector<Trial>& trials);

}  // namespace workbench
