#include "workbench/model/judge/off_profile.hpp"

#include <algorithm>
#include <cmath>

#include "workbench/model/fit/parameter_search.hpp"

namespace workbench {
namespace {

// What the intervals alone say of an effect.
struct Told {
  bool any = false;       // one of its parameters has an "off"
  bool smooth = false;    // and moves the error without steps
  bool excludes = false;  // and an interval without it
};

// What ends an interval of a parameter that moves the error by steps.
enum class Steps { kSlope, kWalk };

bool excludes(const SearchedParameter& parameter, double value, const Interval& interval,
              Steps steps) {
  const double off = *parameter.off;
  const double margin = 1e-3 * (parameter.high - parameter.low);
  // Where the error has steps a slope says little: the test of significance decides.
  const bool by_value = parameter.jumpy && steps == Steps::kSlope;
  return parameter.constant ? value != off
         : by_value         ? std::abs(value - off) > margin
         : parameter.logarithmic && off < parameter.low
             ? interval.low > 1.01 * parameter.low
             : interval.low > off + margin || interval.high < off - margin;
}

bool is_smooth(const SearchedParameter& parameter) {
  return parameter.off && !parameter.constant && !parameter.jumpy;
}

Told told_by(const FitIntervals& intervals, const Fit& fit, const Effect& effect,
             Steps steps = Steps::kSlope) {
  Told told;
  for (std::size_t i = 0; i < fit.p.size(); ++i) {
    const SearchedParameter& parameter = fit.slots[i].parameter;
    if (fit.slots[i].effect != &effect || !parameter.off) continue;
    told.any = true;
    told.smooth = told.smooth || is_smooth(parameter);
    told.excludes =
        told.excludes || excludes(parameter, fit.p[i], intervals.searched[i], steps);
  }
  for (std::size_t i = 0; i < fit.columns.size(); ++i) {
    const FreeRun::Column& column = fit.columns[i];
    if (column.effect != &effect || !column.strength) continue;
    told.any = true;
    const Interval& interval = intervals.solved[i];
    told.excludes = told.excludes || interval.low > 0 || interval.high < 0;
  }
  return told;
}

bool is_told(const Fitter& fitter, const Fit& fit, const Effect& effect,
             const Told& told) {
  if (told.excludes || !told.any) return true;
  return told.smooth &&
         fitter.without(fit, effect).error - fit.error > least_rise(fitter, fit);
}

}  // namespace

bool excludes_off(const Fitter& fitter, const Fit& fit, const FitIntervals& intervals,
                  const Effect& effect) {
  return is_told(fitter, fit, effect, told_by(intervals, fit, effect));
}

bool holds_off(const Fit& fit, const FitIntervals& intervals, const Effect& effect) {
  const Told told = told_by(intervals, fit, effect, Steps::kWalk);
  return told.any && !told.excludes;
}

bool end_by_profile(const Fitter& fitter, const Fit& fit, const Effect& effect,
                    FitIntervals& intervals) {
  constexpr int kHalvings = 5;
  const Told told = told_by(intervals, fit, effect);
  if (!is_told(fitter, fit, effect, told)) return false;
  if (told.excludes) return true;
  const double rise = least_rise(fitter, fit);
  for (std::size_t i = 0; i < fit.p.size(); ++i) {
    const FreeRun::Slot& slot = fit.slots[i];
    if (slot.effect != &effect || !is_smooth(slot.parameter)) continue;
    const double off =
        std::clamp(*slot.parameter.off, slot.parameter.low, slot.parameter.high);
    double outside = to_search(slot.parameter, off);
    double inside = to_search(slot.parameter, fit.p[i]);
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = (outside + inside) / 2;
      Fit moved = fit;
      moved.p[i] = from_search(slot.parameter, middle);
      const FreeRun::Held held{&effect, std::string(slot.parameter.name), moved.p[i]};
      const double error = fitter.refine(moved, {&held, 1}).error;
      (error - fit.error > rise ? outside : inside) = middle;
    }
    const double end = from_search(slot.parameter, outside);
    Interval& interval = intervals.searched[i];
    if (off < fit.p[i]) {
      interval.low = std::max(interval.low, end);
    } else {
      interval.high = std::min(interval.high, end);
    }
  }
  return true;
}

}  // namespace workbench
