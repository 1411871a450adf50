#include "workbench/model/search/left_to_controller.hpp"

#include <algorithm>

#include "workbench/analysis/votes.hpp"
#include "workbench/model/base/controller_law.hpp"

namespace workbench {

Told told_between(const Fitter& fitter, const Fit& base, Identified& identified) {
  const auto has = [&base](bool Description::*what) {
    return std::ranges::any_of(base.effects, [what](const Effect* effect) {
      return effect->description().*what;
    });
  };
  if (fitter.output() != Column::y || has(&Description::recorded)) return Told::kAll;
  if (!follows_law(law_share(fitter.recording().u, fitter.y(), fitter.pieces()))) {
    return Told::kAll;
  }
  if (!is_fault(identified.result(fitter.work()).verdict)) return Told::kNothing;
  return has(&Description::sticks) ? Told::kAll : Told::kStemsFirst;
}

void leave_to_controller(Candidate& candidate) {
  candidate.status = CandidateStatus::kNotExcited;
  candidate.evidence =
      "In this recording nothing but the controller moves u, so that what the process "
      "makes of u is not told from what the controller makes of y; change the setpoint a "
      "few times, or move u by hand.";
}

void let_stems_come_first(std::vector<Trial>& trials) {
  for (Trial& trial : trials) {
    const std::vector<const Effect*> members = members_of(trial);
    const auto any = [&members](bool Description::*what) {
      return std::ranges::any_of(
          members, [what](const Effect* effect) { return effect->description().*what; });
    };
    if (!accepted(trial) || !any(&Description::needs_u) || any(&Description::sticks)) {
      continue;
    }
    leave_in_doubt(
        trial,
        "nothing but the controller moves u here, and the verdict on the valve "
        "finds a stem that does not follow u: ask again when that is in the "
        "model");
  }
}

}  // namespace workbench
