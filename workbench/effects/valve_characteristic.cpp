#include <cmath>

#include "workbench/effects/common.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

class Characteristic final : public Effect {
 public:
  [[nodiscard]] const Description& description() const override {
    static constexpr Description kDescription{
        .code = "valve.characteristic",
        .title = "a nonlinear valve characteristic",
        .place = Place::kCharacteristic,
        .view = View::kLevel,
        .signature = "bends with the level of u, rising and falling alike",
        .cure =
            "Nothing is broken: choose another trim, or linearise the signal in the "
            "controller.",
        .split =
            "hold u at several levels long enough for y to settle, and log the stem "
            "position",
    };
    return kDescription;
  }
  [[nodiscard]] std::vector<SearchedParameter> searched(
      const Situation& s) const override {
    return curve_parameters(s);
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    return curve_starts(s);
  }
  [[nodiscard]] Excitation excitation(const Situation& s,
                                      std::span<const double>) const override {
    return moves_of_u(s);
  }
  [[nodiscard]] std::string evidence(const Situation&, std::span<const double> p,
                                     std::span<const double>) const override {
    return "The valve passes " + number(std::exp(std::abs(p[0])), 3) +
           " times as much flow per unit of u at the " + (p[0] > 0 ? "upper" : "lower") +
           " end of the range of u as at the other.";
  }
  void move(std::span<const double> p, ValveSignal& signal) const override {
    Curve{p[0], p[1], p[2]}.bend(signal.v);
  }
};

}  // namespace

const Effect& valve_characteristic() {
  static const Characteristic effect;
  return effect;
}

}  // namespace workbench::effects
