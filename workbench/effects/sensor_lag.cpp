#include "workbench/effects/common.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

constexpr Description kDescription{
    .code = "sensor.lag",
    .title = "a lag of the sensor",
    .place = Place::kSensor,
    .view = View::kLag,
    .signature = kLagSignature,
    .cure = "Check filter settings of the transmitter, thermowell and impulse lines.",
    .split =
        "compare with a second, faster sensor, or change the damping of the "
        "transmitter",
};

class SensorLag final : public LagEffect {
 public:
  SensorLag() : LagEffect(kDescription, "lag") {}
  [[nodiscard]] std::string evidence(const Situation&, Reals p, Reals) const override {
    return filled("The recorded output trails the process by a lag of {0} s.",
                  {number(p[0], 3)});
  }
  void form(Reals p, ProcessShape& shape) const override { shape.sensor_lag_s = p[0]; }
};

}  // namespace

const Effect& sensor_lag() {
  static const SensorLag effect;
  return effect;
}

}  // namespace workbench::effects
