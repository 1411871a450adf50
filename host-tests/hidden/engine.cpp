#include "hidden/engine.hpp"

#include <algorithm>
#include <exception>

#include "workbench/model/search/ladder.hpp"

namespace hidden {

bool AddedEffect::names(std::string_view wanted) const {
  return effect == wanted ||
         std::find(indistinguishable_from.begin(), indistinguishable_from.end(),
                   wanted) != indistinguishable_from.end();
}

bool Named::said_not_excited(std::string_view effect) const {
  return std::any_of(others.begin(), others.end(), [&](const Judged& judged) {
    return judged.effect == effect && judged.status == "not_excited";
  });
}

Named name_effects(const workbench::Recording& recording) {
  Named named;
  try {
    const workbench::LadderResult ladder = workbench::run_ladder(recording);
    for (std::size_t i = 1; i < ladder.steps.size(); ++i) {
      const workbench::LadderStep& step = ladder.steps[i];
      std::erase_if(named.added, [&](const AddedEffect& added) {
        return added.effect == step.effect;
      });
      if (!step.removed) {
        named.added.push_back({step.effect, step.indistinguishable_from});
      }
      if (i == 1) {
        named.first = named.added;
      }
    }
    for (const workbench::Candidate& candidate : ladder.last.candidates) {
      if (candidate.with.empty()) {
        named.others.push_back(
            {candidate.effect, std::string(workbench::name_of(candidate.status))});
      }
    }
    for (const workbench::EffectTerm& term : ladder.model.effects) {
      for (const workbench::Parameter& p : term.parameters) {
        named.parameters.push_back({term.effect, p.name, p.value, p.low, p.high});
      }
    }
    named.explained = ladder.explained;
    named.left_to_controller = ladder.last.left_to_controller;
    named.rmse_validation = ladder.quality.rmse_validation;
  } catch (const std::exception& error) {
    named.error = error.what();
  }
  return named;
}

double refit_error(const workbench::Recording& recording,
                   const std::vector<std::string>& effects) {
  return workbench::start_model(recording, workbench::Column::y, effects)
      .quality.rmse_validation;
}

}  // namespace hidden
