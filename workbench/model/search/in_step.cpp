#include "workbench/model/search/in_step.hpp"

#include <string>
#include <vector>

namespace workbench {
namespace {

// The same parameter in another fit.
std::optional<double> value_in(const Fit& fit, const FreeRun::Slot& slot) {
  for (std::size_t i = 0; i < fit.p.size(); ++i) {
    const FreeRun::Slot& other = fit.slots[i];
    if (other.effect == slot.effect && other.piece == slot.piece &&
        other.parameter.name == slot.parameter.name) {
      return fit.p[i];
    }
  }
  return std::nullopt;
}

// The initial state is free: the effect may begin with the recording.
Fit added_beside(const Fitter& fitter, const Fit& before, const Fit& now,
                 const Effect& added) {
  Fit start = now;
  std::vector<FreeRun::Held> held;
  for (std::size_t i = 0; i < start.p.size(); ++i) {
    const FreeRun::Slot& slot = start.slots[i];
    if (slot.effect == &added) continue;
    const std::optional<double> value = value_in(before, slot);
    if (!value) continue;
    start.p[i] = *value;
    if (!slot.parameter.initial) {
      held.push_back({slot.effect, std::string(slot.parameter.name), *value});
    }
  }
  Fit out = fitter.refine(start, held);
  out.slots = now.slots;  // free again
  return out;
}

}  // namespace

bool loses_step(const Fitter& fitter, const Fit& before, const Fit& now) {
  return fitter.rmse(now) > fitter.rmse(before) ||
         fitter.rmse_on(now, false) > fitter.rmse_on(before, false);
}

Fit in_step(const Fitter& fitter, const Fit& before, Fit now, const Effect& added) {
  if (!loses_step(fitter, before, now)) return now;
  Fit beside = added_beside(fitter, before, now, added);
  const bool better = beside.error <= before.error &&
                      fitter.rmse(beside) < fitter.rmse(now) &&
                      fitter.rmse_on(beside, false) < fitter.rmse_on(now, false);
  return better ? beside : now;
}

}  // namespace workbench
