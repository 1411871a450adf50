#include "workbench/serve/session_step.hpp"

#include <algorithm>
#include <utility>

#include "workbench/effects/catalogue.hpp"
#include "workbench/model/base/joined.hpp"
#include "workbench/model/fit/fit.hpp"
#include "workbench/model/judge/fitted_model.hpp"

namespace workbench {
namespace {

std::vector<Parameter>* parameters_of(Model& model, const std::string& group) {
  if (group == "process") return &model.process;
  for (EffectTerm& term : model.effects) {
    if (term.effect == group) return &term.parameters;
  }
  return nullptr;
}

Parameter* find(Model& model, const std::string& group, const std::string& name) {
  std::vector<Parameter>* const all = parameters_of(model, group);
  if (all == nullptr) return nullptr;
  const auto found =
      std::ranges::find_if(*all, [&name](const Parameter& p) { return p.name == name; });
  return found == all->end() ? nullptr : &*found;
}

}  // namespace

void check(const Recording& recording, Column output) {
  const Fitter fitter(recording, output);
}

ModelStep step_of(const Recording& recording, Model model) {
  Comparison comparison = compare(recording, model);
  const bool here = Fitter(recording, model.output).fitted_to_this(model);
  return {std::move(model), std::move(comparison), std::nullopt, std::nullopt, here};
}

std::shared_ptr<const ModelStep> shared_step(const Recording& recording, Model model) {
  return std::make_shared<const ModelStep>(step_of(recording, std::move(model)));
}

std::shared_ptr<const Recording> together(const std::shared_ptr<const Recording>& own,
                                          const std::vector<BesideRecording>& beside) {
  std::vector<Recording> all = {*own};
  for (const BesideRecording& other : beside) {
    if (!other.fitted) continue;
    all.push_back(*other.recording);
    const std::string name = all.back().name;
    const auto taken = [&all](const std::string& wish) {
      return std::any_of(all.begin(), all.end() - 1,
                         [&wish](const Recording& r) { return r.name == wish; });
    };
    for (int number = 2; taken(all.back().name); ++number) {
      all.back().name = name + " (" + std::to_string(number) + ")";
    }
  }
  if (all.size() == 1) return own;
  const Split split = own->split;
  Recording out = joined(std::move(all));
  out.start.clear();
  out.manual.clear();  // of the first alone, by its own samples
  out.split = split;
  return std::make_shared<const Recording>(std::move(out));
}

Model fitted_anew(const Recording& recording, const Model& model, const Work& search) {
  const FitQuality before = compare(recording, model).quality;
  Model out = refitted(recording, model, {}, search);
  const FitQuality after = compare(recording, out).quality;
  out.history.push_back({std::string(kRefitted), recording.name, before.rmse, after.rmse,
                         before.rmse_validation, after.rmse_validation});
  return out;
}

Model by_hand(const Recording& recording, const Model& before, Model model,
              std::string_view how) {
  const FitQuality then = compare(recording, before).quality;
  const FitQuality now = compare(recording, model).quality;
  model.history.push_back({std::string(how), recording.name, then.rmse, now.rmse,
                           then.rmse_validation, now.rmse_validation});
  return model;
}

bool is_by_hand(const Model& model) {
  return std::ranges::any_of(model.history, [](const HistoryStep& step) {
    return step.effect == kSetByHand || step.effect == kFittedByHand;
  });
}

bool speaks_of(const ExplainResult& found, const Model& model) {
  return std::ranges::none_of(
      found.candidates, [&model](const Candidate& c) { return model.has(c.effect); });
}

Model with_effects(const Recording& recording, Model model,
                   const std::vector<std::string>& effects, const Worker::Report& report,
                   const Work& search) {
  int number = 0;
  for (const std::string& effect : effects) {
    report(effect, ++number, static_cast<int>(effects.size()));
    model = add_effect(recording, model, effect, standard_catalogue(), search).model;
  }
  return model;
}

Model refitted(const Recording& recording, const Model& model, const HeldNames& held,
               const Work& search) {
  const Catalogue catalogue = standard_catalogue().with(recording.loads);
  const Fitter fitter(recording, model.output, search);
  Model from = model;
  std::vector<FreeRun::Held> kept;
  for (const auto& [group, name] : held) {
    if (const Parameter* parameter = find(from, group, name)) {
      kept.push_back(
          {group == "process" ? nullptr : catalogue.find(group), name, parameter->value});
    }
  }
  Model out = model_of(fitter, fitter.refine(fitter.apply(model, catalogue), kept));
  for (const auto& [group, name] : held) {
    if (Parameter* parameter = find(out, group, name)) {
      parameter->low = parameter->high = parameter->value;
    }
  }
  out.history = model.history;
  return out;
}

}  // namespace workbench
