#include <algorithm>

#include "workbench/effects/common.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/effects/step_response.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

constexpr Description kDescription{
    .code = "process.inverse_response",
    .title = "a process that goes the wrong way first",
    .place = Place::kProcess,
    .view = View::kLag,
    .signature = "follows the change of u with the opposite sign at short lags",
    .cure =
        "Two paths oppose each other, as shrink and swell in a "
        "boiler drum. Tune slowly, without derivative action.",
    .harmless = true,
    .split = "one clear step of u in manual: does the output turn back first?",
};

class InverseResponse final : public ShownByMoves {
 public:
  InverseResponse() : ShownByMoves(kDescription) {}
  [[nodiscard]] SearchedParameters searched(const Situation& s) const override {
    return {{.name = "opposite_time",
             .unit = "s",
             .low = 0,
             .high = s.duration_s() / 10,
             .off = 0.0},
            {.name = "fast_lag",
             .unit = "s",
             .low = s.period_s / 10,
             .high = s.duration_s() / 10,
             .logarithmic = true,
             .open_floor = true}};
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    const double h = s.period_s;
    const double longest =
        std::min(s.duration_s() / 12, std::max(2 * s.first_lag_s, 20 * h));
    std::vector<Values> out;
    for (double wrong_s = h; wrong_s <= longest; wrong_s *= 2) {
      for (const double share : {0.1, 0.4, 1.0}) {
        const double fast_s = std::clamp(share * wrong_s, 0.2 * h, longest);
        out.push_back({wrong_s, fast_s});
      }
    }
    if (out.empty()) out.push_back({longest, 0.3 * longest});
    return out;
  }
  [[nodiscard]] std::string evidence(const Situation&, Reals p, Reals) const override {
    return filled(
        "After every move of u the output first goes the wrong way, as by a fast part of "
        "opposite sign with a lag of {0} s; it takes some {1} s to make up for it.",
        {number(p[1], 3), number(p[0], 3)});
  }
  // What a load does to u in a closed loop looks like a response of the wrong sign;
  // beside the past of y it does not.
  [[nodiscard]] std::string objection(const Situation& s, Reals p, Reals) const override {
    constexpr double kClear = 2.5;  // standard deviations
    const StepResponse seen =
        step_response_of(s.u, s.y, samples_within(s.period_s, p[0] + p[1]));
    return wrong_way(seen) < kClear
               ? "seen one sample ahead, beside the past of y, it does not go the wrong "
                 "way: a load that a controller answers looks the same"
               : "";
  }
  void form(Reals p, ProcessShape& shape) const override {
    shape.opposite_s = p[0];
    shape.fast_lag_s = p[1];
  }
};

}  // namespace

const Effect& process_inverse_response() {
  static const InverseResponse effect;
  return effect;
}

}  // namespace workbench::effects
