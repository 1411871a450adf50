#include "workbench/model/search/left_to_controller.hpp"

#include <algorithm>

#include "workbench/analysis/votes.hpp"
#include "workbench/model/base/controller_law.hpp"

namespace workbench {

bool is_left_to_controller(const Fitter& fitter, const Fit& base,
                           Identified& identified) {
  const bool is_driven = std::ranges::any_of(
      base.effects, [](const Effect* effect) { return effect->description().recorded; });
  if (fitter.output() != Column::y || is_driven) return false;
  if (!follows_law(law_share(fitter.recording().u, fitter.y(), fitter.pieces()))) {
    return false;
  }
  return !is_fault(identified.result(fitter.work()).verdict);
}

void leave_to_controller(Candidate& candidate) {
  candidate.status = CandidateStatus::kNotExcited;
  candidate.evidence =
      "In this recording nothing but the controller moves u, so that what the process "
      "makes of u is not told from what the controller makes of y; change the setpoint a "
      "few times, or move u by hand.";
}

}  // namespace workbench
