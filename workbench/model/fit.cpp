#include "workbench/model/fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "workbench/model/least_squares.hpp"
#include "workbench/model/noise.hpp"
#include "workbench/model/search.hpp"
#include "workbench/model/stem_search.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

const char* const kWhatToRecord =
    "record a stretch in which u and the output move, with several reversals";

// Lags up to an eighth of the recording; of a long one means of several samples are
// looked at, so that the cost has a bound.
double memory_of(std::span<const double> y) {
  constexpr std::size_t kMost = 16384;
  const std::size_t each = (y.size() + kMost - 1) / kMost;
  std::vector<double> means(y.size() / each);
  for (std::size_t i = 0; i < means.size(); ++i) {
    for (std::size_t k = 0; k < each; ++k) means[i] += y[i * each + k];
    means[i] /= static_cast<double>(each);
  }
  const std::vector<double> r = autocorrelation(means, means.size() / 8);
  std::size_t lag = 1;
  while (lag <= r.size() && r[lag - 1] > 0.37) ++lag;
  return static_cast<double>(lag * each);
}

std::vector<double> start_values(const FreeRun& run, const Situation& situation) {
  std::vector<double> p;
  for (const FreeRun::Slot& slot : run.slots()) p.push_back(slot.parameter.low);
  double sum = 0;
  for (const double u : situation.u) sum += u;
  p[0] = sum / static_cast<double>(situation.samples());
  return p;
}

// The values of `fit` where `run` has the same parameter.
std::vector<double> carried(const FreeRun& run, const Fit& fit, const Situation& s) {
  std::vector<double> p = start_values(run, s);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const FreeRun::Slot& slot = run.slots()[i];
    for (std::size_t j = 0; j < fit.p.size(); ++j) {
      if (fit.slots[j].effect == slot.effect &&
          fit.slots[j].parameter.name == slot.parameter.name) {
        p[i] = fit.p[j];
      }
    }
  }
  return p;
}

std::optional<std::size_t> first_lag_slot(const FreeRun& run) {
  if (run.integrating()) return std::nullopt;
  return 1;
}

SearchPoint search_on(FreeRun& run, SearchPoint point, Effort effort) {
  const bool jumpy = has_jumpy(run);
  if (effort == Effort::kScreen) {
    if (jumpy) point = pattern(run, std::move(point), 30);
    return descend(run, std::move(point), 5);
  }
  point = descend(run, std::move(point), 15);
  if (!jumpy) return point;
  for (int round = 0; round < 2; ++round) {
    const double before = point.error;
    point = pattern(run, std::move(point), 120);
    point = descend(run, std::move(point), 8);
    if (!(point.error < 0.999 * before)) break;
  }
  point = descend(run, std::move(point), 8, kNarrowStep);
  point = pattern(run, std::move(point), 40);
  return descend(run, std::move(point), 4, kNarrowStep);
}

}  // namespace

std::size_t Fit::parameters() const {
  std::size_t count = columns.size();
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const SearchedParameter& parameter = slots[i].parameter;
    const bool absent = parameter.optional && parameter.off == p[i];
    count += !parameter.constant && !absent;
  }
  return count;
}

std::optional<double> Fit::process_value(std::string_view name) const {
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (slots[i].effect == nullptr && slots[i].parameter.name == name) return p[i];
  }
  return std::nullopt;
}

std::vector<double> Fit::searched_of(const Effect& effect) const {
  std::vector<double> out;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (slots[i].effect == &effect) out.push_back(p[i]);
  }
  return out;
}

std::vector<double> Fit::solved_of(const Effect& effect) const {
  std::vector<double> out;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].effect == &effect) out.push_back(coefficients[i]);
  }
  return out;
}

Fitter::Fitter(const Recording& recording, Column output)
    : recording_(&recording), output_(output) {
  const std::vector<double>& y = recording.values(output);
  const std::string name(name_of(output));
  if (recording.u.empty() || y.empty()) {
    throw InputError(recording.name, 0, 0, "the columns u and " + name,
                     "no " + (recording.u.empty() ? std::string("u") : name),
                     "choose a recording that has them");
  }
  if (recording.size() < Blocks::kFewestSamples) {
    throw InputError(recording.name, 0, 0,
                     "at least " + std::to_string(Blocks::kFewestSamples) + " samples",
                     std::to_string(recording.size()), kWhatToRecord);
  }
  u_ = recording.u;
  if (output == Column::x) {
    std::copy(recording.u.begin() + 1, recording.u.end(), u_.begin());
  }
  base_ = situation_of(u_, y, recording.period_s);
  if (!(base_.y_span() > 0) || !(base_.u_span() > 0)) {
    throw InputError(recording.name, 0, 0, "u and " + name + " that move",
                     "a constant " + (base_.u_span() > 0 ? name : std::string("u")),
                     kWhatToRecord);
  }
  memory_samples_ = memory_of(y);
  blocks_ = Blocks(recording.size(), memory_samples_);
  base_.estimation = blocks_.estimation();
}

Fit Fitter::taken(FreeRun& run, std::vector<const Effect*> effects,
                  std::vector<double> p) const {
  Fit fit;
  fit.error = run.run(p);
  fit.effects = std::move(effects);
  fit.slots = run.slots();
  fit.p = std::move(p);
  fit.columns = run.columns();
  fit.coefficients.assign(run.coefficients().begin(), run.coefficients().end());
  fit.residual.assign(run.residual().begin(), run.residual().end());
  fit.integrating = run.integrating();
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

// The output less the loads of a fit, as the identification sees it. It looks at all
// samples, but only proposes: the estimation blocks decide.
std::span<const SeenStem> Fitter::stems_behind(const Fit& fit) const {
  std::vector<const Effect*> loads;
  for (const Effect* effect : fit.effects) {
    if (effect->description().place == Place::kLoad) loads.push_back(effect);
  }
  if (stems_less_ == loads) return stems_;
  std::vector<double> y(base_.y.begin(), base_.y.end());
  FreeRun run(base_, blocks_, fit.effects);
  run.run(fit.p);
  for (std::size_t i = 0; i < run.columns().size(); ++i) {
    const Effect* effect = run.columns()[i].effect;
    if (std::find(loads.begin(), loads.end(), effect) == loads.end()) continue;
    for (std::size_t k = 0; k < y.size(); ++k) {
      y[k] -= run.coefficients()[i] * run.column(i)[k];
    }
  }
  stems_ = stems_seen(u_, y, base_.period_s);
  stems_less_ = std::move(loads);
  return stems_;
}

std::optional<Fit> Fitter::built(const std::vector<const Effect*>& effects,
                                 const Effect*& missing) const {
  // What shapes the process without being searched belongs in from the beginning.
  std::vector<const Effect*> structural;
  for (const Effect* effect : effects) {
    if (effect->searched(base_).empty() && effect->solved().empty()) {
      structural.push_back(effect);
    }
  }
  FreeRun run(base_, blocks_, structural);
  const std::vector<double> p = start_values(run, base_);
  SearchPoint best = evaluate(run, p);
  if (const auto slot = first_lag_slot(run)) {
    const SearchedParameter& parameter = run.slots()[*slot].parameter;
    for (double lag_s = parameter.low; lag_s < parameter.high; lag_s *= 2) {
      std::vector<double> next = p;
      next[*slot] = lag_s;
      SearchPoint point = evaluate(run, std::move(next));
      if (point.error < best.error) best = std::move(point);
    }
  }
  best = descend(run, std::move(best), 20);
  Fit fit = taken(run, structural, best.p);
  for (const Effect* effect : effects) {
    if (std::find(structural.begin(), structural.end(), effect) != structural.end()) {
      continue;
    }
    auto next = extend(fit, *effect, Effort::kThorough);
    missing = effect;
    if (!next) return std::nullopt;
    fit = std::move(*next);
  }
  return fit.effects.size() > 1 ? reconsider(std::move(fit), nullptr) : fit;
}

std::optional<Fit> Fitter::start_if(const std::vector<const Effect*>& effects) const {
  const Effect* missing = nullptr;
  return built(effects, missing);
}

Fit Fitter::start(const std::vector<const Effect*>& effects) const {
  const Effect* missing = nullptr;
  if (auto fit = built(effects, missing)) return std::move(*fit);
  throw InputError(recording_->name, 0, 0,
                   "a recording that shows " + std::string(missing->code()),
                   "nothing to start from", "leave the effect out");
}

std::optional<Fit> Fitter::extend(const Fit& base, const Effect& effect,
                                  Effort effort) const {
  Situation here = situation(base);
  if (effect.description().sticks) here.stems = stems_behind(base);
  const std::vector<Values> starts = effect.starts(here);
  if (starts.empty()) return std::nullopt;
  std::vector<const Effect*> effects = base.effects;
  effects.push_back(&effect);
  FreeRun run(base_, blocks_, effects);
  const std::vector<double> carried_p = carried(run, base, base_);
  const std::size_t first = run.first_slot(effect);
  const auto lag_slot = first_lag_slot(run);
  // A missing effect pulls the first lag away; starts are judged with other ones, too:
  // all with the first few, the best with the rest.
  std::vector<double> lags = {0};
  if (lag_slot) {
    const double own = carried_p[*lag_slot];
    const double all = base_.duration_s();
    lags = {own,     0.2 * own,    0.015 * all, 0.5 * own,
            2 * own, 0.0015 * all, 0.005 * all, 0.05 * all};
    for (const SeenStem& stem : here.stems) {
      if (stem.lag_s > 0) lags.insert(lags.begin(), stem.lag_s);
    }
  }
  const auto judged = [&](std::vector<double> p, std::size_t from, std::size_t to) {
    SearchPoint best;
    for (std::size_t i = from; i < std::min(to, lags.size()); ++i) {
      if (lag_slot) p[*lag_slot] = lags[i];
      SearchPoint point = evaluate(run, p);
      if (i == from || point.error < best.error) best = std::move(point);
    }
    return best;
  };
  const auto sort = [](std::vector<SearchPoint>& points) {
    std::stable_sort(
        points.begin(), points.end(),
        [](const SearchPoint& a, const SearchPoint& b) { return a.error < b.error; });
  };
  const std::size_t few_lags = 3 + here.stems.size();
  constexpr std::size_t kClosest = 12;
  std::vector<SearchPoint> points;
  for (const Values& values : starts) {
    std::vector<double> p = carried_p;
    std::copy(values.begin(), values.end(),
              p.begin() + static_cast<std::ptrdiff_t>(first));
    points.push_back(judged(std::move(p), 0, few_lags));
  }
  sort(points);
  for (std::size_t i = 0; i < std::min(kClosest, points.size()); ++i) {
    if (lags.size() <= few_lags) break;
    SearchPoint point = judged(points[i].p, few_lags, lags.size());
    if (point.error < points[i].error) points[i] = std::move(point);
  }
  sort(points);
  const std::size_t tried =
      std::min<std::size_t>(points.size(), effort == Effort::kScreen ? 3 : 5);
  SearchPoint best;
  for (std::size_t i = 0; i < tried; ++i) {
    SearchPoint point = search_on(run, points[i], Effort::kScreen);
    if (i == 0 || point.error < best.error) best = std::move(point);
  }
  if (effort == Effort::kThorough) {
    best = search_on(run, std::move(best), Effort::kThorough);
  }
  return taken(run, std::move(effects), std::move(best.p));
}

Fit Fitter::refine(const Fit& base) const {
  FreeRun run(base_, blocks_, base.effects);
  SearchPoint point = evaluate(run, carried(run, base, base_));
  point = search_on(run, std::move(point), Effort::kThorough);
  return taken(run, base.effects, std::move(point.p));
}

Fit Fitter::reconsider(Fit base, const Effect* last) const {
  constexpr double kGain = 0.995;
  const std::vector<const Effect*> effects = base.effects;
  for (const Effect* effect : effects) {
    if (effect == last || effect->searched(base_).empty()) continue;
    const std::optional<Fit> anew =
        extend(without(base, *effect), *effect, Effort::kThorough);
    if (!anew || !(anew->error < kGain * base.error)) continue;
    Fit ordered = *anew;
    ordered.effects = effects;
    base = refine(ordered);
  }
  return base;
}

Fit Fitter::without(const Fit& base, const Effect& effect) const {
  std::vector<const Effect*> effects;
  for (const Effect* other : base.effects) {
    if (other != &effect) effects.push_back(other);
  }
  FreeRun run(base_, blocks_, effects);
  const std::vector<double> p = carried(run, base, base_);
  SearchPoint best = search_on(run, evaluate(run, p), Effort::kThorough);
  if (const auto slot = first_lag_slot(run)) {
    for (const double factor : {0.3, 3.0}) {
      std::vector<double> other = p;
      other[*slot] = std::max(p[*slot], base_.period_s) * factor;
      SearchPoint point = search_on(run, evaluate(run, other), Effort::kScreen);
      if (point.error < best.error) best = std::move(point);
    }
  }
  return taken(run, std::move(effects), std::move(best.p));
}

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
    if (elsewhere && !fitted_to_this(model)) continue;  // a load is of its recording
    effects.push_back(effect);
  }
  const bool here = fitted_to_this(model);
  FreeRun run(base_, blocks_, effects);
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
  fit.error =
      run.run_with(p, plant, here ? FreeRun::Rows::kEstimation : FreeRun::Rows::kAll);
  fit.coefficients.assign(run.coefficients().begin(), run.coefficients().end());
  fit.residual.assign(run.residual().begin(), run.residual().end());
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
