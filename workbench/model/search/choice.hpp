// Which of the effects that pass is named.
#pragma once

#include <vector>

#include "workbench/model/search/trial.hpp"

namespace workbench {

/// Of those that pass, the one with the best score stands for its group; those that the
/// data can tell from it wait until it is in the model. What the readings themselves show
/// comes first, and no model explains it away. Null where none passes. Statuses, groups
/// and scores of `trials` are brought up to date.
[[nodiscard]] Trial* choose(const Fitter& fitter, std::vector<Trial>& trials);

/// `best` lists the effect of `other` as what it may be, and is listed in turn.
void name_beside(Trial& other, Trial& best);

/// `other` is listed as what `named` may be: it lists `named` in turn and is not
/// rejected.
void name_back(Candidate& other, const Effect& named);

/// Each lists all others of the group, the first one first.
void name_each_other(const std::vector<Trial*>& group);

}  // namespace workbench
