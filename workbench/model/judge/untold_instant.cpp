#include "workbench/model/judge/untold_instant.hpp"

#include <algorithm>
#include <optional>

#include "workbench/model/judge/intervals.hpp"

namespace workbench {

double untold_instant_s(const Fitter& fitter, const Fit& fit, const Effect& effect) {
  constexpr double kLags = 3;            // a lag has then forgotten 95 %
  constexpr double kOfRecording = 0.02;  // what is sharper is sudden in any case
  const Situation here = fitter.situation(fit);
  const double memory_s = std::max(kLags * (here.first_lag_s + here.second_lag_s),
                                   kOfRecording * here.duration_s());
  std::optional<FitIntervals> intervals;
  double longest_s = 0;
  for (std::size_t i = 0; i < fit.slots.size(); ++i) {
    if (fit.slots[i].effect != &effect || !fit.slots[i].parameter.sudden ||
        !FreeRun::is_searched(fit.slots, fit.p, i)) {
      continue;
    }
    if (!intervals) intervals = thorough_intervals_of(fitter, fit);
    const Interval& told = intervals->searched[i];
    longest_s = std::max(longest_s, told.high - told.low);
  }
  return longest_s > memory_s ? longest_s : 0;
}

}  // namespace workbench
