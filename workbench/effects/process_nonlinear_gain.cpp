#include <cmath>

#include "workbench/effects/common.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

class NonlinearGain final : public Effect {
 public:
  [[nodiscard]] const Description& description() const override {
    static constexpr Description kDescription{
        .code = "process.nonlinear_gain",
        .title = "a gain that depends on the operating point",
        .place = Place::kProcess,
        .view = View::kLevel,
        .signature = "bends with the level of the process, rising and falling alike",
        .cure =
            "Nothing is broken: schedule the controller gain over the operating point.",
        .split =
            "repeat the same step of u at several operating points, and log the stem "
            "position",
    };
    return kDescription;
  }
  [[nodiscard]] std::vector<SearchedParameter> searched(
      const Situation& s) const override {
    auto parameters = curve_parameters(s);
    parameters.push_back(
        {.name = "lag_follows_gain", .unit = "1", .high = 1, .constant = true});
    return parameters;
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    if (s.integrating) return {};
    std::vector<Values> out;
    for (const Values& start : curve_starts(s)) {
      for (const double follows : {0.0, 1.0}) {
        out.push_back(start);
        out.back().push_back(follows);
      }
    }
    return out;
  }
  [[nodiscard]] Excitation excitation(const Situation& s,
                                      std::span<const double>) const override {
    return moves_of_u(s);
  }
  [[nodiscard]] std::string evidence(const Situation&, std::span<const double> p,
                                     std::span<const double>) const override {
    return "The process answers " + number(std::exp(std::abs(p[0])), 3) +
           " times as strongly at the " + (p[0] > 0 ? "upper" : "lower") +
           " end of its range as at the other.";
  }
  // A storage with a curved outflow, or a curve behind linear dynamics.
  void form(std::span<const double> p, ProcessShape& shape) const override {
    if (p[3] > 0.5) shape.storage = {p[0], p[1], p[2]};
  }
  void bend(std::span<const double> p, std::span<double> z) const override {
    bend_curve(p[0], p[1], p[2], z);
  }
};

}  // namespace

const Effect& process_nonlinear_gain() {
  static const NonlinearGain effect;
  return effect;
}

}  // namespace workbench::effects
