// Fitter::apply(): a model as it is stored, against a recording; and how far a fit is
// off.
#include <cmath>
#include <limits>

#include "workbench/model/fit.hpp"
#include "workbench/model/least_squares.hpp"
#include "workbench/recording/input_error.hpp"

namespace workbench {

bool Fitter::fitted_to_this(const Model& model) const {
  const Recording& r = *recording_;
  return model.fitted.samples == r.size() && model.fitted.period_s == r.period_s &&
         model.fitted.first_u == r.u.front() && model.fitted.last_u == r.u.back();
}

namespace {

const Parameter* find(const std::vector<Parameter>& parameters, std::string_view name) {
  for (const Parameter& parameter : parameters) {
    if (parameter.name == name) return &parameter;
  }
  return nullptr;
}

const std::vector<Parameter>* parameters_of(const Model& model, const Effect* effect) {
  if (effect == nullptr) return &model.process;
  for (const EffectTerm& term : model.effects) {
    if (term.effect == effect->code()) return &term.parameters;
  }
  return nullptr;
}

double value_in(const Model& model, const Effect* effect, std::string_view name) {
  const std::vector<Parameter>* own = parameters_of(model, effect);
  const Parameter* parameter = own != nullptr ? find(*own, name) : nullptr;
  if (parameter == nullptr) {
    throw InputError(
        "model", 0, 0,
        "the parameter '" + std::string(name) + "' of " +
            (effect != nullptr ? std::string(effect->code()) : "the process"),
        "none", "fit the model again with `stickband model`");
  }
  return parameter->value;
}

}  // namespace

// The searched part of the initial state of another recording, on all of its samples.
void Fitter::find_start(FreeRun& run, std::vector<double>& p,
                        std::span<const double> plant) const {
  constexpr int kGrid = 40;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const SearchedParameter& parameter = run.slots()[i].parameter;
    if (!parameter.initial) continue;
    double least = std::numeric_limits<double>::infinity();
    double best = p[i];
    for (int step = 0; step <= kGrid; ++step) {
      p[i] = std::lerp(parameter.low, parameter.high, step / double{kGrid});
      run.run_with(p, plant, FreeRun::Rows::kAll);
      const double error = dot(run.residual(), run.residual());
      if (error < least) best = p[i];
      least = std::min(least, error);
    }
    p[i] = best;
  }
}

Fit Fitter::apply(const Model& model, const Catalogue& catalogue) const {
  std::vector<const Effect*> effects;
  for (const EffectTerm& term : model.effects) {
    const Effect* effect = catalogue.find(term.effect);
    if (effect == nullptr) {
      throw InputError("model", 0, 0, "an effect of the catalogue", quoted(term.effect),
                       "known effects: " + catalogue.codes());
    }
    const bool elsewhere =
        effect->description().place == Place::kLoad || !effect->solved().empty();
    const bool recorded =
        effect->description().recorded && !effect->starts(base_).empty();
    // A load is of its recording, but for one that this recording holds, too.
    if (elsewhere && !recorded && !fitted_to_this(model)) continue;
    effects.push_back(effect);
  }
  const bool here = fitted_to_this(model);
  FreeRun run(base_, blocks_, effects, *work_);
  std::vector<double> p;
  for (const FreeRun::Slot& slot : run.slots()) {
    const std::string_view name = slot.parameter.name;
    const Parameter* state = find(model.initial_state, name);
    const double initial = here && state != nullptr ? state->value : 0;
    p.push_back(slot.parameter.initial ? initial : value_in(model, slot.effect, name));
  }
  // The columns are known after a run; their plant coefficients come from the model.
  run.run(p);
  std::vector<double> plant;
  for (const FreeRun::Column& column : run.columns()) {
    plant.push_back(column.initial ? 0 : value_in(model, column.effect, column.name));
  }
  if (!here) find_start(run, p, plant);
  Fit fit = taken(run, effects, p);
  const FreeRun::Rows rows = here ? FreeRun::Rows::kEstimation : FreeRun::Rows::kAll;
  record(run, run.run_with(p, plant, rows), fit);
  return fit;
}

double Fitter::rmse(const Fit& fit) const {
  return std::sqrt(dot(fit.residual, fit.residual) /
                   static_cast<double>(fit.residual.size()));
}

double Fitter::rmse_on(const Fit& fit, bool estimation) const {
  double sum = 0;
  double count = 0;
  for (const Block& block : blocks_.blocks()) {
    if (block.estimation != estimation) continue;
    const auto part = std::span<const double>(fit.residual)
                          .subspan(block.first, block.last - block.first);
    sum += dot(part, part);
    count += static_cast<double>(part.size());
  }
  return count > 0 ? std::sqrt(sum / count) : 0;
}

}  // namespace workbench
