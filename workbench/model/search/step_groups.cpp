#include "workbench/model/search/step_groups.hpp"

#include <algorithm>

#include "workbench/model/judge/rivals.hpp"
#include "workbench/model/search/choice.hpp"
#include "workbench/recording/filled.hpp"

namespace workbench {

void group_anew(const Fitter& fitter, const Fit& fit,
                const std::vector<const Effect*>& given, const Catalogue& catalogue,
                std::vector<LadderStep>& steps) {
  if (fit.effects.size() < given.size() + 2) return;
  for (const Effect* effect : fit.effects) {
    const auto step = std::find_if(
        steps.rbegin(), steps.rend(),
        [&](const LadderStep& s) { return !s.removed && s.effect == effect->code(); });
    if (step == steps.rend()) continue;
    step->indistinguishable_from = rivals_of(fitter, fit, *effect, catalogue);
  }
}

void leave_rivals_open(const std::vector<LadderStep>& steps, const Model& model,
                       const Catalogue& catalogue, std::vector<Candidate>& left) {
  for (const LadderStep& step : steps) {
    const Effect* effect = catalogue.find(step.effect);
    if (step.removed || effect == nullptr || !model.has(step.effect)) continue;
    // Another name for what the readings show says so itself.
    if (effect->description().place == Place::kRecord) continue;
    for (Candidate& c : left) {
      const bool is_rival = std::ranges::count(step.indistinguishable_from, c.effect) > 0;
      const bool is_named = std::ranges::count(c.indistinguishable_from, step.effect) > 0;
      if (!is_rival || is_named || !c.with.empty()) continue;
      if (c.status == CandidateStatus::kRejected) {
        c.evidence =
            filled("It may stand in the place of {0}; beside that it adds nothing.",
                   {step.effect});
      }
      name_back(c, *effect);
    }
  }
}

}  // namespace workbench
