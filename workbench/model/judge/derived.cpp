#include "workbench/model/judge/derived.hpp"

#include <algorithm>

namespace workbench {

std::vector<DerivedValue> derived_of(const Fit& fit) {
  std::vector<DerivedValue> out;
  for (const Effect* effect : fit.effects) {
    for (const DerivedParameter& parameter : effect->derived()) {
      DerivedValue derived;
      derived.effect = effect;
      derived.parameter = &parameter;
      for (std::size_t part = 0; part < derived.slots.size(); ++part) {
        const auto slot = std::find_if(
            fit.slots.begin(), fit.slots.end(), [&](const FreeRun::Slot& candidate) {
              return candidate.effect == effect &&
                     candidate.parameter.name == parameter.sum_of[part];
            });
        derived.slots[part] = static_cast<std::size_t>(slot - fit.slots.begin());
        derived.value += fit.p[derived.slots[part]];
      }
      out.push_back(derived);
    }
  }
  return out;
}

Interval within_bounds(const Fit& fit, const DerivedValue& derived, double down,
                       double up) {
  double low = 0;
  double high = 0;
  double least = 0;
  for (const std::size_t slot : derived.slots) {
    const SearchedParameter& parameter = fit.slots[slot].parameter;
    low += parameter.low;
    high += parameter.high;
    least = std::max(least, parameter.resolution);
  }
  return {std::max(low, derived.value - std::max(down, least)),
          std::min(high, derived.value + std::max(up, least))};
}

}  // namespace workbench
