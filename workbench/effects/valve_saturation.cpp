#include <algorithm>

#include "workbench/effects/common.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/output_limit.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

constexpr Description kDescription{
    .code = "valve.saturation",
    .title = "a travel or signal limit",
    .place = Place::kLimit,
    .view = View::kLevel,
    .signature =
        "is one-sided: it grows with u beyond one level, rising and falling alike",
    .cure =
        "Look for a mechanical stop, a wrong span of the signal, or an undersized "
        "valve.",
    .split = "drive u beyond the level for a while and watch the stem",
    .limits = true,
};

class Saturation final : public Effect {
 public:
  Saturation() : Effect(kDescription) {}
  [[nodiscard]] SearchedParameters searched(const Situation& s) const override {
    return {{.name = "lower_limit",
             .unit = "u",
             .low = s.u_low,
             .high = s.u_high,
             .jumpy = true,
             .off = s.u_low},
            {.name = "upper_limit",
             .unit = "u",
             .low = s.u_low,
             .high = s.u_high,
             .jumpy = true,
             .off = s.u_high}};
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    std::vector<Values> out;
    for (const double share : {0.03, 0.08, 0.15, 0.25, 0.4}) {
      const double low = quantile(s.u, share);
      const double high = quantile(s.u, 1 - share);
      out.push_back({s.u_low, high});
      out.push_back({low, s.u_high});
      if (share < 0.3) out.push_back({low, high});
    }
    return out;
  }
  [[nodiscard]] Excitation excitation(const Situation& s, Reals p) const override {
    const double margin = s.u_span() / 50;
    return {count_stays(s.u, p[1] + margin, true, memory_of(s)) +
                count_stays(s.u, p[0] - margin, false, memory_of(s)),
            "separate stays of u beyond a limit", kLeastMoves};
  }
  [[nodiscard]] std::string evidence(const Situation& s, Reals p, Reals) const override {
    const double margin = s.u_span() / 100;
    const bool above = p[1] < s.u_high - margin;
    const bool below = p[0] > s.u_low + margin;
    const std::string high = number(p[1], 4);
    const std::string low = number(p[0], 4);
    if (above && below) {
      return filled("The output stops answering above u = {0} and below u = {1}.",
                    {high, low});
    }
    return above ? filled("The output stops answering above u = {0}.", {high})
                 : filled("The output stops answering below u = {0}.", {low});
  }
  [[nodiscard]] std::string objection(const Situation& s, Reals p, Reals) const override {
    return p[0] + s.u_span() / 50 < p[1] ? "" : "its limits leave the valve no travel";
  }
  [[nodiscard]] std::string out_of_reach(const Situation& s) const override {
    const std::vector<OutputLimit> limits = limits_of_output(s.u);
    if (limits.empty()) return {};
    return filled(
        "u itself rests at {0}, {1} times and {2} of all samples: this limit acts before "
        "u is recorded, so that the model lacks nothing there. Look for windup, and for "
        "a range or a valve that is too small.",
        {number(limits[0].level, 4), std::to_string(limits[0].stays),
         number(100 * limits[0].share, 2) + " %"});
  }
  void move(Reals p, ValveSignal& signal) const override {
    const double high = std::max(p[0], p[1]);
    for (double& v : signal.v) v = std::clamp(v, p[0], high);
  }
};

}  // namespace

const Effect& valve_saturation() {
  static const Saturation effect;
  return effect;
}

}  // namespace workbench::effects
