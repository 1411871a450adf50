#include <algorithm>

#include "workbench/effects/common.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

constexpr Description kDescription{
    .code = "valve.backlash",
    .title = "backlash",
    .place = Place::kFriction,
    .view = View::kDirection,
    .signature = "differs by half the gap between rising and falling u, without a jump",
    .cure =
        "Look for play: worn linkage, loose coupling between actuator and stem, a "
        "worn feedback arm. Where the stem follows u at once as u turns back, the play "
        "is in the transmitter: its float, displacer or linkage.",
    .split = "log the stem position, or one fast and one slow stroke",
};

class Backlash final : public Effect {
 public:
  Backlash() : Effect(kDescription) {}
  [[nodiscard]] SearchedParameters searched(const Situation& s) const override {
    return {{.name = "deadband",
             .unit = "u",
             .low = 0,
             .high = std::max(s.u_span(), 1e-12),
             .jumpy = true,
             .off = 0.0,
             .resolution = stem_resolution(s)},
            searched_stem_start(s, "loose_stem_start")};
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    std::vector<Values> out;
    for (double share = 0.015; share < 0.9; share *= 1.35) {
      for (const double start : {-0.4, 0.0, 0.4}) {
        const double gap = share * s.u_span();
        out.push_back({gap, start * gap});
      }
    }
    return out;
  }
  [[nodiscard]] Excitation excitation(const Situation& s, Reals p) const override {
    return reversals_beyond(s, p[0], "reversals of u wider than the gap");
  }
  [[nodiscard]] std::string evidence(const Situation&, Reals p, Reals) const override {
    return filled(
        "At every reversal {0} of the travel of u is lost, and no jump is needed behind "
        "it.",
        {number(p[0], 3)});
  }
  void move(Reals p, ValveSignal& signal) const override {
    move_with_friction({p[0], 0, 0, 0, false, p[1]}, signal);
  }
};

}  // namespace

const Effect& valve_backlash() {
  static const Backlash effect;
  return effect;
}

}  // namespace workbench::effects
