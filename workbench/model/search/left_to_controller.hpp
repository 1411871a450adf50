// Whether a recording says anything of what lies between u and y.
#pragma once

#include "workbench/model/fit/fit.hpp"
#include "workbench/model/search/explain.hpp"
#include "workbench/model/search/identified.hpp"

namespace workbench {

/// (W31) True where nothing but the controller moves u (controller_law.hpp), neither the
/// identification finds a valve that makes the loop cycle nor `base` has a recorded load:
/// what the process makes of u is then not told from what the controller makes of y. Asks
/// `identified` only where u follows the law. Throws as Work::check().
[[nodiscard]] bool is_left_to_controller(const Fitter& fitter, const Fit& base,
                                         Identified& identified);

/// Not excited, and why.
void leave_to_controller(Candidate& candidate);

}  // namespace workbench
