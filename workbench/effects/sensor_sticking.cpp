#include <algorithm>

#include "workbench/effects/effects.hpp"
#include "workbench/effects/holds.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

class Sticking final : public Effect {
 public:
  [[nodiscard]] const Description& description() const override {
    static constexpr Description kDescription{
        .code = "sensor.sticking",
        .title = "a sensor that sticks",
        .place = Place::kRecord,
        .view = View::kTime,
        .signature =
            "grows while the reading repeats and is gone after its jump: the output "
            "holds to the last digit",
        .cure =
            "Check the transmitter: float or displacer, impulse lines, its own deadband "
            "or damping, and whether a system in between only passes on larger changes.",
        .split =
            "record at the transmitter, with exception reporting switched off, or "
            "compare with a second sensor",
        .needs_u = false,
        .least_share = -0.005,
        .adds_up = true,
    };
    return kDescription;
  }
  [[nodiscard]] std::vector<SearchedParameter> searched(
      const Situation& s) const override {
    const double most = std::max(s.y_span(), 1e-12);
    return {{.name = "band",
             .unit = "y",
             .high = most,
             .constant = true,
             .within_factor = 1.25,
             .off = 0.0},
            {.name = "held_share", .unit = "1", .high = 1, .constant = true}};
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    const Holder holder = who_holds(s.u, s.y);
    if (holder != Holder::kSensor && holder != Holder::kEither) return {};
    constexpr double kOwnDoing = 0.5;  // of the repeats, made by filling gaps
    const Held held = held_in(s.y, same_reading(s.y_low, s.y_high));
    if (s.filled_share > kOwnDoing * held.share) return {};
    return {{held.least_jump, held.share}};
  }
  [[nodiscard]] Excitation excitation(const Situation& s,
                                      std::span<const double>) const override {
    const Held held = held_in(s.y, same_reading(s.y_low, s.y_high));
    return {static_cast<int>(held.jumps), "jumps of the reading"};
  }
  [[nodiscard]] std::string evidence(const Situation& s, std::span<const double> p,
                                     std::span<const double>) const override {
    const bool answered = who_holds(s.u, s.y) == Holder::kSensor;
    return filled(
        answered
            ? "For {0} % of the samples the reading repeats to the last digit, then it "
              "jumps by {1} y or more; u runs straight meanwhile and answers the "
              "jumps, so the controller saw it hold, too."
            : "For {0} % of the samples the reading repeats to the last digit, then it "
              "jumps by {1} y or more.",
        {number(100 * p[1], 3), number(p[0], 3)});
  }
  // Readings that noise does not move do not repeat by chance.
  [[nodiscard]] std::optional<double> own_test(const Situation&,
                                               std::span<const double>) const override {
    return 1e-12;
  }
  void record(std::span<const double>, const Situation& s,
              std::span<double> y) const override {
    hold_like(s.y, same_reading(s.y_low, s.y_high), y);
  }
};

}  // namespace

const Effect& sensor_sticking() {
  static const Sticking effect;
  return effect;
}

}  // namespace workbench::effects
