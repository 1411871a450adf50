#include <algorithm>

#include "workbench/effects/common.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

constexpr Description kDescription{
    .code = "process.dead_time",
    .title = "dead time",
    .place = Place::kProcess,
    .view = View::kLag,
    .signature =
        "follows the change of u, one sign at short lags and the other at longer "
        "ones",
    .cure =
        "Look for transport: long pipes, a distant analyser, a slow scan. Shorten it "
        "or tune for it.",
    .split =
        "one fast and one slow stroke: dead time loses seconds, backlash loses "
        "travel of u",
};

class DeadTime final : public ShownByMoves {
 public:
  DeadTime() : ShownByMoves(kDescription) {}
  [[nodiscard]] std::vector<SearchedParameter> searched(
      const Situation& s) const override {
    return {{.name = "dead_time",
             .unit = "s",
             .low = 0,
             .high = s.duration_s() / 10,
             .off = 0.0,
             .resolution = s.period_s / 20}};
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    std::vector<Values> out;
    const double longest =
        std::min(s.duration_s() / 10, std::max(4 * s.first_lag_s, 30 * s.period_s));
    for (double time = s.period_s; time <= longest; time *= 1.6) out.push_back({time});
    if (out.empty()) out.push_back({longest});
    return out;
  }
  [[nodiscard]] std::string evidence(const Situation&, std::span<const double> p,
                                     std::span<const double>) const override {
    return filled(
        "Every move of u reaches the output {0} s late, fast and slow ones alike.",
        {number(p[0], 3)});
  }
  void form(std::span<const double> p, ProcessShape& shape) const override {
    shape.dead_time_s = p[0];
  }
};

}  // namespace

const Effect& process_dead_time() {
  static const DeadTime effect;
  return effect;
}

}  // namespace workbench::effects
