// What is said of a trial that the recording does not support.
#pragma once

#include <string>

#include "workbench/model/search/trial.hpp"

namespace workbench {

/// Of a trial that the recording cannot show, or whose gain may be chance: its status and
/// evidence. `share`: what it takes away of the squared error on the samples that judge.
void conclude_unsupported(const Fitter& fitter, double share, Trial& trial);

/// True where chance is out of the question, and no load could have done it.
[[nodiscard]] bool beyond_doubt(const Trial& trial);

/// True where the recording could show it; beside a load its events count, too.
[[nodiscard]] bool is_excited(const Trial& trial);

/// A sentence of each of `members` that says what it does in `fit`.
[[nodiscard]] std::string evidence_of(const Fitter& fitter, const Fit& fit,
                                      const std::vector<const Effect*>& members);

}  // namespace workbench
