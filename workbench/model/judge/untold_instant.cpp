#include "workbench/model/judge/untold_instant.hpp"

#include <algorithm>

#include "workbench/model/judge/intervals.hpp"

namespace workbench {

double untold_instant_s(const Fitter& fitter, const Fit& fit, const Effect& effect) {
  constexpr double kLags = 3;            // a lag has then forgotten 95 %
  constexpr double kOfRecording = 0.02;  // what is sharper is sudden in any case
  const auto sudden = std::ranges::find_if(fit.slots, [&](const FreeRun::Slot& slot) {
    return slot.effect == &effect && slot.parameter.sudden;
  });
  if (sudden == fit.slots.end()) return 0;
  const Situation here = fitter.situation(fit);
  const double memory_s = std::max(kLags * (here.first_lag_s + here.second_lag_s),
                                   kOfRecording * here.duration_s());
  const auto slot = static_cast<std::size_t>(sudden - fit.slots.begin());
  const Interval told = thorough_intervals_of(fitter, fit).searched[slot];
  return told.high - told.low > memory_s ? told.high - told.low : 0;
}

}  // namespace workbench
