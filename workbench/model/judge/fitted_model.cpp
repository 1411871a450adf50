#include "workbench/model/judge/fitted_model.hpp"

#include <algorithm>
#include <utility>

#include "workbench/model/judge/off_profile.hpp"

namespace workbench {

namespace {

// How many times the error a limit may leave that is told as absent.
constexpr double kAsLittle = 1.001;

// (W22) A limit that may as well lie where it would be absent has not been reached.
bool may_be_absent(const FreeRun::Slot& slot, const Interval& interval) {
  const SearchedParameter& parameter = slot.parameter;
  if (slot.effect == nullptr || !slot.effect->description().limits || !parameter.off) {
    return false;
  }
  const double margin = 1e-3 * (parameter.high - parameter.low);
  return interval.low - margin <= *parameter.off &&
         *parameter.off <= interval.high + margin;
}

// Two limits of one effect do not cross: each may lie at most where the other is told,
// and where both would still meet, halfway.
void part_limits(const Fit& fit, FitIntervals& intervals) {
  for (std::size_t i = 0; i + 1 < fit.p.size(); ++i) {
    const FreeRun::Slot& lower = fit.slots[i];
    const FreeRun::Slot& upper = fit.slots[i + 1];
    if (lower.effect == nullptr || lower.effect != upper.effect ||
        lower.parameter.name != "lower_limit" || upper.parameter.name != "upper_limit" ||
        fit.p[i] > fit.p[i + 1]) {
      continue;
    }
    Interval& below = intervals.searched[i];
    Interval& above = intervals.searched[i + 1];
    below.high = std::min(below.high, fit.p[i + 1]);
    above.low = std::max(above.low, fit.p[i]);
    if (below.high <= above.low) continue;
    const double middle =
        std::clamp((below.high + above.low) / 2, fit.p[i], fit.p[i + 1]);
    below.high = above.low = middle;
  }
}

}  // namespace

Fit with_absent_limits(const Fitter& fitter, Fit fit, const FitIntervals& intervals) {
  const double error = fitter.rmse(fit);
  for (std::size_t i = 0; i < fit.p.size(); ++i) {
    if (!may_be_absent(fit.slots[i], intervals.searched[i])) continue;
    std::vector<double> p = fit.p;
    p[i] = *fit.slots[i].parameter.off;
    if (p[i] == fit.p[i]) continue;
    Fit without = fitter.at(fit, std::move(p));
    const double left = fitter.rmse(without);
    // Less is left only where coefficients were held: they stay as they were.
    if (left >= error && left <= kAsLittle * error) fit = std::move(without);
  }
  return fit;
}

std::vector<Parameter> parameters_of(const Fit& fit, const FitIntervals& intervals,
                                     const Effect* effect) {
  std::vector<Parameter> out;
  for (std::size_t i = 0; i < fit.p.size(); ++i) {
    const SearchedParameter& parameter = fit.slots[i].parameter;
    if (fit.slots[i].effect != effect || parameter.initial) continue;
    const double value = fit.p[i];
    out.push_back({std::string(parameter.name), std::string(parameter.unit), value,
                   std::min(value, intervals.searched[i].low),
                   std::max(value, intervals.searched[i].high), parameter.low,
                   parameter.high});
  }
  for (const DerivedValue& derived : intervals.derived) {
    if (derived.effect != effect) continue;
    out.push_back({std::string(derived.parameter->name),
                   std::string(derived.parameter->unit), derived.value,
                   derived.interval.low, derived.interval.high, -1e300, 1e300, true});
  }
  for (std::size_t i = 0; i < fit.columns.size(); ++i) {
    const FreeRun::Column& column = fit.columns[i];
    if (column.effect != effect || column.initial) continue;
    out.push_back({column.name, column.unit, fit.coefficients[i], intervals.solved[i].low,
                   intervals.solved[i].high, -1e300, 1e300});
  }
  return out;
}

FitIntervals told_intervals_of(const Fitter& fitter, const Fit& fit) {
  FitIntervals intervals = thorough_intervals_of(fitter, fit);
  for (const Effect* effect : fit.effects) {
    end_by_profile(fitter, fit, *effect, intervals);
  }
  return intervals;
}

ToldFit told_of(const Fitter& fitter, const Fit& found) {
  FitIntervals intervals = told_intervals_of(fitter, found);
  Fit fit = with_absent_limits(fitter, found, intervals);
  if (fit.p != found.p) intervals = told_intervals_of(fitter, fit);
  part_limits(fit, intervals);
  return {std::move(fit), std::move(intervals)};
}

Model model_of(const Fitter& fitter, const Fit& found) {
  return model_of(fitter, told_of(fitter, found));
}

Model model_of(const Fitter& fitter, const ToldFit& told) {
  const auto& [fit, intervals] = told;
  Model model;
  model.output = fitter.output();
  model.process = parameters_of(fit, intervals, nullptr);
  for (const Effect* effect : fit.effects) {
    model.effects.push_back({std::string(effect->code()),
                             parameters_of(fit, intervals, effect), at_edge(fit, *effect),
                             holds_off(fit, intervals, *effect)});
  }
  for (std::size_t i = 0; i < fit.p.size(); ++i) {
    const SearchedParameter& parameter = fit.slots[i].parameter;
    if (!parameter.initial || fit.slots[i].judges) continue;
    model.initial_state.push_back({state_name(parameter.name, fit.slots[i].piece),
                                   std::string(parameter.unit), fit.p[i],
                                   intervals.searched[i].low, intervals.searched[i].high,
                                   parameter.low, parameter.high});
  }
  for (std::size_t i = 0; i < fit.columns.size(); ++i) {
    if (!fit.columns[i].initial || fit.columns[i].judges) continue;
    model.initial_state.push_back({state_name(fit.columns[i].name, fit.columns[i].piece),
                                   fit.columns[i].unit, fit.coefficients[i],
                                   intervals.solved[i].low, intervals.solved[i].high,
                                   -1e300, 1e300});
  }
  model.fitted = fitter.fitted();
  model.noise = fit.weight;
  return model;
}

}  // namespace workbench
