#include "workbench/model/search/one_step.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>

#include "workbench/model/judge/fitted_model.hpp"
#include "workbench/model/judge/merit.hpp"
#include "workbench/model/search/in_step.hpp"
#include "workbench/model/search/told_ahead.hpp"

namespace workbench {

const Effect& effect_named(std::string_view code, const Catalogue& catalogue) {
  const Effect* effect = catalogue.find_asked(code);
  if (effect == nullptr) {
    throw std::invalid_argument(catalogue.no_effect(code));
  }
  return *effect;
}

std::vector<const Effect*> effects_named(const std::vector<std::string>& codes,
                                         const Catalogue& catalogue) {
  std::vector<const Effect*> effects;
  for (const std::string& code : codes) {
    const Effect& effect = effect_named(code, catalogue);
    if (contains(effects, effect)) {
      throw std::invalid_argument(code + " is named twice");
    }
    effects.push_back(&effect);
  }
  return effects;
}

HistoryStep step_of(const Fitter& fitter, std::string effect, const Fit* before,
                    const Fit& after) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  return {std::move(effect),
          fitter.recording().name,
          before != nullptr ? fitter.rmse(*before) : kNone,
          fitter.rmse(after),
          before != nullptr ? fitter.rmse_on(*before, false) : kNone,
          fitter.rmse_on(after, false)};
}

FittedModel start_model(const Recording& recording, Column output,
                        const std::vector<std::string>& with, const Catalogue& catalogue,
                        const Work& work) {
  const std::vector<const Effect*> effects =
      effects_named(with, catalogue.with(recording.loads));
  const Fitter fitter(recording, output, work);
  const Fit fit = fitter.start(effects);
  FittedModel out{model_of(fitter, fit), quality(fitter, fit)};
  out.model.history.push_back(step_of(fitter, "process", nullptr, fit));
  return out;
}

FittedModel add_effect(const Recording& recording, const Model& model,
                       std::string_view effect, const Catalogue& catalogue,
                       const Work& work) {
  const Effect& added = effect_named(effect, catalogue.with(recording.loads));
  if (model.has(added.code())) {
    throw std::invalid_argument("the model already has " + std::string(added.code()));
  }
  const Fitter fitter(recording, model.output, work);
  const Fit before = fitter.refine(fitter.apply(model, catalogue));
  const std::optional<Fit> after = fitter.extend(before, added, Effort::kThorough);
  if (!after) {
    throw std::invalid_argument("nothing in " + recording.name + " looks like " +
                                std::string(effect));
  }
  const Fit free = in_step(fitter, before, fitter.reconsider(*after, &added), added);
  std::optional<ToldAhead> ahead;
  if (before.weight.empty() && !lowers_error(fitter, before, free)) {
    ahead = told_ahead(fitter, before, free, added);
  }
  const Fit& now = ahead ? ahead->fit : free;
  FittedModel out{model_of(fitter, now), quality(fitter, now)};
  out.model.history = model.history;
  out.model.history.push_back(step_of(fitter, std::string(added.code()), &before, now));
  if (ahead) out.model.history.back().ahead = ahead->errors;
  return out;
}

FittedModel remove_effect(const Recording& recording, const Model& model,
                          std::string_view effect, const Catalogue& catalogue,
                          const Work& work) {
  if (!model.has(effect)) {
    throw std::invalid_argument("the model has no " + std::string(effect));
  }
  const Fitter fitter(recording, model.output, work);
  const Fit before = fitter.apply(model, catalogue);
  const auto gone = std::find_if(before.effects.begin(), before.effects.end(),
                                 [&](const Effect* e) { return e->code() == effect; });
  const Fit now = fitter.without(before, **gone);
  FittedModel out{model_of(fitter, now), quality(fitter, now)};
  out.model.history = model.history;
  out.model.history.push_back(step_of(fitter, '-' + std::string(effect), &before, now));
  return out;
}

}  // namespace workbench
