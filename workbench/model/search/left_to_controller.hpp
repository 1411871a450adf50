// Whether a recording says anything of what lies between u and y.
#pragma once

#include <vector>

#include "workbench/model/fit/fit.hpp"
#include "workbench/model/search/explain.hpp"
#include "workbench/model/search/identified.hpp"
#include "workbench/model/search/trial.hpp"

namespace workbench {

/// What a recording tells of what lies between u and y.
enum class Told {
  kAll,
  kStemsFirst,  ///< a stem, and the rest once that is in the model
  kLoads,       ///< nothing but loads
  kNothing,     ///< not that either where it swings or drifts: the valve, or the model
};

/// (W31) Where little but the controller moves u (controller_law.hpp), what the process
/// makes of u is not told from what the controller makes of y, unless the identification
/// finds a valve that makes the loop cycle, or `base` has a recorded load. Loads are told
/// where it finds that the valve does not stick. Asks
/// `identified` only where u follows the law; where the time is up before it answers,
/// kAll: nothing is tried either. Throws Stopped.
[[nodiscard]] Told told_between(const Fitter& fitter, const Fit& base,
                                Identified& identified);

/// Not excited, and why.
void leave_to_controller(Candidate& candidate);

/// Leaves undecided what was accepted and is not told: where stems come first what lies
/// between u and y without one, where nothing is told a load that swings.
void leave_untold(Told told, std::vector<Trial>& trials);

/// (W34) Leaves undecided what was accepted between u and y without a stem and in whose
/// model u explains less of y, on the samples that judge, than a controller that answers
/// the load could do.
void leave_under_loads(const Fitter& fitter, std::vector<Trial>& trials);

}  // namespace workbench
