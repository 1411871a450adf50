#include <algorithm>

#include "workbench/effects/effects.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

class Overflow final : public Effect {
 public:
  [[nodiscard]] const Description& description() const override {
    static constexpr Description kDescription{
        .code = "process.overflow",
        .title = "an output that is cut off above a level",
        .place = Place::kOverflow,
        .view = View::kLevel,
        .signature = "is one-sided: the model rises where the output stays flat",
        .cure =
            "Look for an overflow, a relief valve, or a transmitter at the end of its "
            "range.",
        .split =
            "widen the range of the sensor, or look at the overflow while it happens",
    };
    return kDescription;
  }
  [[nodiscard]] std::vector<SearchedParameter> searched(
      const Situation& s) const override {
    return {{.name = "level",
             .unit = "y",
             .low = s.y_low + 0.3 * s.y_span(),
             .high = s.y_high,
             .jumpy = true,
             .off = s.y_high},
            {.name = "spilling_storage", .unit = "1", .high = 2, .constant = true}};
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    std::vector<Values> out;
    for (const double share : {0.995, 0.97, 0.93, 0.87, 0.8, 0.7, 0.6}) {
      const double level = quantile(s.y, share);
      if (level < s.y_low + 0.3 * s.y_span()) continue;
      for (const double storage : {0.0, 1.0}) out.push_back({level, storage});
      if (s.second_lag_s > 0) out.push_back({level, 2});
    }
    if (out.empty()) out.push_back({s.y_high, 0});
    return out;
  }
  [[nodiscard]] Excitation excitation(const Situation& s,
                                      std::span<const double> p) const override {
    const double reach = std::min(2 * s.residual_std, s.y_span() / 20);
    return {count_stays(s.y, p[0] - reach, true, memory_of(s)),
            "separate stays of the output at the level"};
  }
  [[nodiscard]] std::string evidence(const Situation&, std::span<const double> p,
                                     std::span<const double>) const override {
    return "The output stays at " + number(p[0], 4) + " where u asks for more.";
  }
  // Storage 0: only the reading is cut off, the process goes on rising behind it. 1: the
  // last storage spills, so it falls as soon as the inflow does. 2: the first of two
  // does.
  [[nodiscard]] std::optional<Ceiling> ceiling(std::span<const double> p) const override {
    return Ceiling{p[0], p[1] > 0.5, p[1] > 1.5};
  }
};

}  // namespace

const Effect& process_overflow() {
  static const Overflow effect;
  return effect;
}

}  // namespace workbench::effects
