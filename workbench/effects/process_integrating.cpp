#include "workbench/effects/common.hpp"
#include "workbench/effects/effects.hpp"

namespace workbench::effects {
namespace {

constexpr Description kDescription{
    .code = "process.integrating",
    .title = "an integrating process",
    .place = Place::kProcess,
    .view = View::kTime,
    .signature = "wanders slowly, because the model settles where the process does not",
    .cure = "It is a level, or a pressure without outflow. Tune as an integrating loop.",
    .harmless = true,
    .split = "hold u constant away from balance for a while: does y settle or run away?",
};

class Integrating final : public ShownByMoves {
 public:
  Integrating() : ShownByMoves(kDescription) {}
  [[nodiscard]] std::string evidence(const Situation&, Reals, Reals) const override {
    return "The output keeps moving as long as u is off balance; it does not settle.";
  }
  void form(Reals, ProcessShape& shape) const override { shape.integrating = true; }
};

}  // namespace

const Effect& process_integrating() {
  static const Integrating effect;
  return effect;
}

}  // namespace workbench::effects
