#include "workbench/model/judge/off_profile.hpp"

#include <algorithm>
#include <cmath>

#include "workbench/model/fit/parameter_search.hpp"

namespace workbench {
namespace {

// What the intervals alone say of an effect.
struct Told {
  bool any = false;       // one of its parameters has an "off"
  bool smooth = false;    // and it moves the error without steps
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

// Where its signal was recorded, how strong a load is and how slow are told for one
// another, without steps.
bool has_known_shape(const Effect& effect) {
  return effect.description().recorded;
}

// (W35) About a value that is not zero, as wide by factors as `interval` is by sums.
Interval by_factors(double value, const Interval& interval) {
  constexpr double kMost = 1e6;  // of one frequency the gain alone tells nothing
  const double factor =
      std::min(std::exp((interval.high - interval.low) / (2 * std::abs(value))), kMost);
  return {std::min(value / factor, value * factor),
          std::max(value / factor, value * factor)};
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
    told.smooth = told.smooth || has_known_shape(effect);
    const Interval& interval = intervals.solved[i];
    told.excludes = told.excludes || interval.low > 0 || interval.high < 0;
  }
  // A stem that does not jump is there all the same where its band is not 0.
  for (const DerivedValue& derived : intervals.derived) {
    if (derived.effect != &effect) continue;
    told.any = true;
    told.excludes = told.excludes || derived.interval.low > 0;
  }
  return told;
}

bool is_told(const Fitter& fitter, const Fit& fit, const Effect& effect,
             const Told& told) {
  if (told.excludes || !told.any) return true;
  return told.smooth &&
         fitter.without(fit, effect).error - fit.error > least_rise(fitter, fit);
}

// How the error rises from a fit when one of its parameters is held elsewhere and all
// else is fitted again.
class Profile {
 public:
  Profile(const Fitter& fitter, const Fit& fit, std::size_t slot)
      : fitter_(fitter),
        fit_(fit),
        slot_(fit.slots[slot]),
        at_(slot),
        rise_(least_rise(fitter, fit)) {}

  [[nodiscard]] bool rises_at(double value) const {
    Fit moved = fit_;
    moved.p[at_] = value;
    const FreeRun::Held held{slot_.effect, std::string(slot_.parameter.name), value};
    return fitter_.refine(moved, {&held, 1}).error - fit_.error > rise_;
  }

  // Where it begins to rise by more than noise on the way to `outside`, where it does.
  [[nodiscard]] double end_towards(double outside) const {
    constexpr int kHalvings = 5;
    double out = to_search(slot_.parameter, outside);
    double in = to_search(slot_.parameter, fit_.p[at_]);
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = (out + in) / 2;
      (rises_at(from_search(slot_.parameter, middle)) ? out : in) = middle;
    }
    return from_search(slot_.parameter, out);
  }

 private:
  const Fitter& fitter_;
  const Fit& fit_;
  const FreeRun::Slot& slot_;
  std::size_t at_;
  double rise_;
};

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
  const Told told = told_by(intervals, fit, effect);
  if (!is_told(fitter, fit, effect, told)) return false;
  if (told.excludes) return true;
  for (std::size_t i = 0; i < fit.p.size(); ++i) {
    const SearchedParameter& parameter = fit.slots[i].parameter;
    if (fit.slots[i].effect != &effect || !is_smooth(parameter)) continue;
    const Profile profile(fitter, fit, i);
    const double off = std::clamp(*parameter.off, parameter.low, parameter.high);
    const bool above = off < fit.p[i];
    const double near = profile.end_towards(off);
    const double most = above ? parameter.high : parameter.low;
    const double far = profile.rises_at(most) ? profile.end_towards(most) : most;
    Interval& interval = intervals.searched[i];
    interval.low = std::max(interval.low, above ? near : far);
    interval.high = std::min(interval.high, above ? far : near);
  }
  for (std::size_t i = 0; i < fit.columns.size(); ++i) {
    const FreeRun::Column& column = fit.columns[i];
    if (column.effect != &effect || !column.strength || !has_known_shape(effect))
      continue;
    intervals.solved[i] = by_factors(fit.coefficients[i], intervals.solved[i]);
  }
  return true;
}

}  // namespace workbench
