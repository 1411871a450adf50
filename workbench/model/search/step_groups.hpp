// What the steps of a ladder may as well be.
#pragma once

#include <vector>

#include "workbench/effects/catalogue.hpp"
#include "workbench/model/fit/fit.hpp"
#include "workbench/model/search/ladder.hpp"

namespace workbench {

/// Looks for the rivals of each effect of the final `fit` again where it has two or more
/// that were not `given`: beside a second one the first can often be told better, or no
/// longer.
void group_anew(const Fitter& fitter, const Fit& fit,
                const std::vector<const Effect*>& given, const Catalogue& catalogue,
                std::vector<LadderStep>& steps);

/// Of `left`, judged beside the effects of `model`: what has nothing to add because it
/// may stand in the place of one of them is not rejected. The two name each other.
void leave_rivals_open(const std::vector<LadderStep>& steps, const Model& model,
                       const Catalogue& catalogue, std::vector<Candidate>& left);

}  // namespace workbench
