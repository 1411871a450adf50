// Fitter::apply(): a model as it is stored, against a recording; and how far a fit is
// off, or at the end of what it may search.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "workbench/model/base/least_squares.hpp"
#include "workbench/model/fit/fit.hpp"
#include "workbench/model/fit/lags_in_series.hpp"
#include "workbench/model/fit/parameter_search.hpp"
#include "workbench/model/fit/sudden_instant.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {

bool has_recorded_load(const std::vector<const Effect*>& effects) {
  return std::ranges::any_of(
      effects, [](const Effect* effect) { return effect->description().recorded; });
}

bool has_load(const std::vector<const Effect*>& effects) {
  return std::ranges::any_of(
      effects, [](const Effect* effect) { return effect->description().is_load(); });
}

bool at_edge(const Fit& fit, const Effect& effect) {
  if (effect.ends_there(fit.searched_of(effect))) return false;
  for (std::size_t i = 0; i < fit.p.size(); ++i) {
    const SearchedParameter& parameter = fit.slots[i].parameter;
    if (fit.slots[i].effect != &effect || !FreeRun::is_searched(fit.slots, fit.p, i)) {
      continue;
    }
    if (edge_of(parameter, fit.p[i]) != Edge::kNone) return true;
  }
  return false;
}

FittedRecording Fitter::fitted() const {
  const Recording& r = *recording_;
  std::size_t last = 0;
  std::size_t samples = 0;
  for (const Piece& piece : pieces_) {
    if (piece.judges) continue;
    last = piece.last;
    samples += piece.last - piece.first;
  }
  const std::span<const double> y = r.values(output_);
  return {r.name,        samples,
          r.period_s,    r.u.front(),
          r.u[last - 1], fingerprint_of({std::span(r.u).first(last), y.first(last)})};
}

bool Fitter::fitted_to_this(const Model& model) const {
  const FittedRecording here = fitted();
  return model.fitted.samples == here.samples && model.fitted.period_s == here.period_s &&
         model.fitted.first_u == here.first_u && model.fitted.last_u == here.last_u &&
         (model.fitted.fingerprint.empty() ||
          model.fitted.fingerprint == here.fingerprint);
}

namespace {

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

// A form that its effect may take and this file does not know, and all that goes with it:
// without it the effect has not taken it.
std::optional<double> value_without_form(const Model& model, const FreeRun::Slot& slot,
                                         std::span<const FreeRun::Slot> slots) {
  const std::vector<Parameter>* own = parameters_of(model, slot.effect);
  if (own == nullptr || find(*own, slot.parameter.name) != nullptr) return std::nullopt;
  const bool lacks_form = std::ranges::any_of(slots, [&](const FreeRun::Slot& other) {
    const std::string_view form = other.parameter.only_with;
    return other.effect == slot.effect && !form.empty() && find(*own, form) == nullptr;
  });
  const SearchedParameter& parameter = slot.parameter;
  if (!lacks_form || (!parameter.constant && parameter.only_with.empty())) {
    return std::nullopt;
  }
  return parameter.only_with.empty() ? parameter.low : parameter.high;
}

// A limit at its bound was not reached where the model was fitted: neither is it here.
double value_here(const Model& model, const FreeRun::Slot& slot,
                  std::span<const FreeRun::Slot> slots) {
  const SearchedParameter& parameter = slot.parameter;
  if (const auto absent = value_without_form(model, slot, slots)) return *absent;
  const double value = value_in(model, slot.effect, parameter.name);
  // Whatever bounds a file tells: the simulation divides by it.
  if (parameter.logarithmic && !(value > 0)) {
    throw InputError("model", 0, 0,
                     filled("a number above 0 for {0}", {std::string(parameter.name)}),
                     number(value), "fit the model again with `stickband model`");
  }
  if (slot.effect == nullptr || !slot.effect->description().limits || !parameter.off) {
    return value;
  }
  const Parameter& stored = *find(*parameters_of(model, slot.effect), parameter.name);
  const bool at_low = *parameter.off <= parameter.low && value <= stored.bound_low;
  const bool at_high = *parameter.off >= parameter.high && value >= stored.bound_high;
  return at_low || at_high ? *parameter.off : value;
}

// Of a grid the value of slot `i` that leaves least over all samples; what one piece
// starts from does not change the others.
void best_of_grid(const FreeRun& run, std::vector<double>& p, std::size_t i, int steps,
                  const std::function<void()>& simulate) {
  const SearchedParameter& parameter = run.slots()[i].parameter;
  double least = std::numeric_limits<double>::infinity();
  double best = p[i];
  for (int step = 0; step <= steps; ++step) {
    p[i] = std::lerp(parameter.low, parameter.high, step / static_cast<double>(steps));
    simulate();
    const double error = dot(run.judged(), run.judged());
    if (error < least) best = p[i];
    least = std::min(least, error);
  }
  p[i] = best;
}

}  // namespace

// The searched part of the initial state of another recording, on all of its samples.
void Fitter::find_start(FreeRun& run, std::vector<double>& p,
                        std::span<const double> plant) const {
  constexpr int kSteps = 40;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!run.slots()[i].parameter.initial) continue;
    best_of_grid(run, p, i, kSteps, [&] { run.run_with(p, plant, FreeRun::Rows::kAll); });
  }
}

// That of the pieces that judge, which no search moves. From a start a little off, a stem
// may slip at other moments all along.
void Fitter::find_judging_start(FreeRun& run, std::vector<double>& p) const {
  constexpr int kSteps = 60;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (run.slots()[i].judges) best_of_grid(run, p, i, kSteps, [&] { run.run(p); });
  }
}

Fit Fitter::found(FreeRun& run, std::vector<const Effect*> effects,
                  std::vector<double> p) const {
  p = slowest_first(run, std::move(p));
  for (const SuddenInstant& instant : sudden_instants(run.slots(), p, base_)) {
    p = place_of(instant, base_, blocks_, run.effects(), std::move(p), *work_).p;
  }
  return taken(run, std::move(effects), std::move(p));
}

Blocks Fitter::judging(const Fit& fit, const std::vector<const Effect*>& among) const {
  Blocks out = blocks_;
  for (const SuddenInstant& instant : sudden_instants(fit.slots, fit.p, base_)) {
    if (contains(among, *fit.slots[instant.slot].effect)) {
      out = out.fitting(instant.stretch);
    }
  }
  return out;
}

Fit Fitter::apply(const Model& model, const Catalogue& catalogue) const {
  std::vector<const Effect*> effects;
  for (const EffectTerm& term : model.effects) {
    const Effect* effect = catalogue.find(term.effect);
    if (effect == nullptr) {
      throw InputError("model", 0, 0, "an effect of the catalogue",
                       workbench::quoted(term.effect),
                       "known effects: " + catalogue.codes());
    }
    const bool absent = effect->description().recorded && effect->starts(base_).empty();
    if ((stays_behind(*effect) || absent) && !fitted_to_this(model)) continue;
    effects.push_back(effect);
  }
  const bool here = fitted_to_this(model);
  // Another recording was made under another load.
  FreeRun run(base_, blocks_, effects, *work_,
              here ? model.noise : std::vector<double>{});
  std::vector<double> p;
  for (const FreeRun::Slot& slot : run.slots()) {
    const std::string_view name = slot.parameter.name;
    const Parameter* state = find(model.initial_state, state_name(name, slot.piece));
    const double initial = here && state != nullptr ? state->value : 0;
    p.push_back(slot.parameter.initial ? initial : value_here(model, slot, run.slots()));
  }
  // The columns are known after a run; their plant coefficients come from the model.
  run.run(p);
  std::vector<double> plant;
  for (const FreeRun::Column& column : run.columns()) {
    plant.push_back(column.initial ? 0 : value_in(model, column.effect, column.name));
  }
  if (here) {
    find_judging_start(run, p);
  } else {
    find_start(run, p, plant);
  }
  Fit fit = taken(run, effects, p);
  const FreeRun::Rows rows = here ? FreeRun::Rows::kEstimation : FreeRun::Rows::kAll;
  record(run, run.run_with(p, plant, rows), fit);
  return fit;
}

Situation Fitter::situation(const Fit& fit) const {
  Situation s = base_;
  s.residual = fit.residual;
  s.first_lag_s = fit.process_value("first_lag").value_or(0);
  for (std::size_t i = 0; i < fit.slots.size(); ++i) {
    if (fit.slots[i].parameter.name == "second_lag") s.second_lag_s = fit.p[i];
  }
  s.integrating = fit.integrating;
  s.residual_std = rmse(fit);
  return s;
}

void Fitter::add_loads(const Fit& fit, double factor, std::span<double> signal,
                       const Effect* only) const {
  const auto is_asked_for = [only](const FreeRun::Column& column) {
    return column.effect != nullptr && column.effect->description().is_load() &&
           (only == nullptr || column.effect == only);
  };
  if (std::none_of(fit.columns.begin(), fit.columns.end(), is_asked_for)) return;
  FreeRun run(base_, blocks_, fit.effects, *work_, fit.weight);
  run.run(fit.p);
  for (std::size_t i = 0; i < fit.columns.size(); ++i) {
    if (!is_asked_for(fit.columns[i])) continue;
    const double c = factor * fit.coefficients[i];
    for (std::size_t k = 0; k < signal.size(); ++k) signal[k] += c * run.column(i)[k];
  }
}

std::vector<double> Fitter::simulated(const Fit& fit) const {
  std::vector<double> out(base_.y.begin(), base_.y.end());
  for (std::size_t k = 0; k < out.size(); ++k) out[k] -= fit.residual[k];
  auto aside = fit.aside.begin();
  for (const SampleRange& range : blocks_.left_out()) {
    for (std::size_t k = range.first; k < range.last; ++k) out[k] -= *aside++;
  }
  return out;
}

double Fitter::rmse(const Fit& fit) const {
  double sum = 0;
  double count = 0;
  for (const Block& block : blocks_.blocks()) {
    if (is_judged() && !block.estimation) continue;
    const auto part = std::span<const double>(fit.residual)
                          .subspan(block.first, block.last - block.first);
    sum += dot(part, part);
    count += static_cast<double>(part.size());
  }
  return std::sqrt(sum / count);
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
