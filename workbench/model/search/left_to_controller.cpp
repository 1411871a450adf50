#include "workbench/model/search/left_to_controller.hpp"

#include <algorithm>

#include "workbench/analysis/votes.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/base/controller_law.hpp"
#include "workbench/model/judge/merit.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

bool is_stem(const Effect* effect) {
  return effect->description().is_stem();
}

// The identification judges stems for itself.
bool is_between_without_stem(const std::vector<const Effect*>& members) {
  const auto is_between = [](const Effect* effect) {
    return effect->description().needs_u;
  };
  return std::ranges::any_of(members, is_between) &&
         std::ranges::none_of(members, is_stem);
}

Told told_by_verdict(const Fit& base, ident::Verdict verdict) {
  if (!is_fault(verdict)) {
    return verdict == ident::Verdict::kNoStiction ? Told::kLoads : Told::kNothing;
  }
  return std::ranges::any_of(base.effects, is_stem) ? Told::kAll : Told::kStemsFirst;
}

}  // namespace

Told told_between(const Fitter& fitter, const Fit& base, Identified& identified) {
  if (fitter.output() != Column::y || has_recorded_load(base.effects)) return Told::kAll;
  if (!follows_law(law_share(fitter.recording().u, fitter.y(), fitter.pieces()))) {
    return Told::kAll;
  }
  try {
    return told_by_verdict(base, identified.result(fitter.work()).verdict);
  } catch (const OutOfTime&) {
    return Told::kAll;
  }
}

void leave_to_controller(Candidate& candidate) {
  candidate.status = CandidateStatus::kNotExcited;
  candidate.evidence =
      "In this recording little but the controller moves u, so that what the process "
      "makes of u is not told from what the controller makes of y; change the setpoint a "
      "few times, or move u by hand.";
}

void leave_untold(Told told, std::vector<Trial>& trials) {
  if (told == Told::kAll || told == Told::kLoads) return;
  for (Trial& trial : trials) {
    if (!accepted(trial)) continue;
    const std::vector<const Effect*> members = members_of(trial);
    if (told == Told::kNothing) {
      if (std::ranges::count(members, &effects::disturbance_ramp()) > 0) {
        leave_in_doubt(trial,
                       "little but the controller moves u here, so that the drift may be "
                       "what the model makes of u");
        continue;
      }
      if (std::ranges::count(members, &effects::disturbance_sinusoid()) == 0) continue;
      leave_in_doubt(
          trial,
          "little but the controller moves u here: a loop that is tuned too tightly, or "
          "a valve that sticks a little, would swing like that, too");
      continue;
    }
    if (!is_between_without_stem(members)) continue;
    leave_in_doubt(trial,
                   "little but the controller moves u here, and the verdict on the valve "
                   "finds a stem that does not follow u: ask again when that is in the "
                   "model");
  }
}

void leave_under_loads(const Fitter& fitter, std::vector<Trial>& trials) {
  constexpr double kLeast = 0.6;  // of the squares of y
  for (Trial& trial : trials) {
    if (!accepted(trial) || !is_between_without_stem(members_of(trial))) continue;
    const double share = share_of_u(fitter, *trial.fit);
    if (share > kLeast) continue;
    leave_in_doubt(
        trial,
        filled("u explains no more than {0} % of the output with it, and loads move the "
               "rest: if a controller answers loads so large, what the process makes "
               "of u is not told from what the controller makes of y; move u or the "
               "setpoint more, or record the load",
               {number(std::max(100 * share, 0.0), 3)}));
  }
}

}  // namespace workbench
