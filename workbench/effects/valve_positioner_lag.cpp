#include "workbench/effects/common.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

constexpr Description kDescription{
    .code = "valve.positioner_lag",
    .title = "a lag of the positioner",
    .place = Place::kPositioner,
    .view = View::kLag,
    .signature = kLagSignature,
    .cure =
        "Check the positioner: supply pressure, pilot valve, gain; a slow one limits "
        "the loop. Where the process has next to no lag of its own beside it, the "
        "lag may be the process's, and the curve that of its output or of the sensor.",
    .split = "log the stem position",
};

class PositionerLag final : public LagEffect {
 public:
  PositionerLag() : LagEffect(kDescription, "lag") {}
  [[nodiscard]] std::string evidence(const Situation&, Reals p, Reals) const override {
    return filled(
        "The output follows u through one more lag of {0} s before the valve's "
        "nonlinearities.",
        {number(p[0], 3)});
  }
  void move(Reals p, ValveSignal& signal) const override {
    signal.settling_s = p[0];
    lag_means(signal.weight(), p[0], signal.v);
  }
};

}  // namespace

const Effect& valve_positioner_lag() {
  static const PositionerLag effect;
  return effect;
}

}  // namespace workbench::effects
