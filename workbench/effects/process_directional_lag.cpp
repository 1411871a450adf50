#include <algorithm>
#include <cmath>

#include "workbench/effects/common.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

constexpr Description kDescription{
    .code = "process.directional_lag",
    .title = "a lag that depends on direction",
    .place = Place::kProcess,
    .view = View::kDirection,
    .signature = "lasts longer after moves of u one way than after those the other way",
    .cure =
        "A drive that coasts, a vessel that is heated but cools by "
        "itself, answer so. Tune for the slower way, or schedule the controller by "
        "direction.",
    .harmless = true,
    .split = "the same step of u up and down again, each held until the output settles",
    .bends = true,
};

class DirectionalLag final : public Effect {
 public:
  DirectionalLag() : Effect(kDescription) {}
  [[nodiscard]] SearchedParameters searched(const Situation& s) const override {
    constexpr double kMost = 20;
    return {{.name = "falling_over_rising",
             .unit = "1",
             .low = 1 / kMost,
             .high = kMost,
             .logarithmic = true,
             .off = 1.0},
            {.name = "storage_start",
             .unit = "u",
             .low = -s.u_span(),
             .high = s.u_span(),
             .initial = true}};
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    if (s.integrating) return {};
    return {{0.3, 0}, {0.6, 0}, {1.6, 0}, {3, 0}};
  }
  // It takes moves both ways.
  [[nodiscard]] Excitation excitation(const Situation& s, Reals) const override {
    constexpr double kTurn = 0.1;  // of the range of u
    return {reversals_of_u(s, kTurn * s.u_span()), "turns of u", kLeastMoves};
  }
  [[nodiscard]] std::string evidence(const Situation&, Reals p, Reals) const override {
    return filled(p[0] > 1 ? "The output takes {0} times as long to follow u down as up."
                           : "The output takes {0} times as long to follow u up as down.",
                  {number(std::exp(std::abs(std::log(p[0]))), 3)});
  }
  [[nodiscard]] std::string objection(const Situation& s, Reals p, Reals) const override {
    constexpr double kSeen = 2;  // samples that the slower lag lasts, at least
    return s.first_lag_s * std::max(1.0, p[0]) < kSeen * s.period_s
               ? "the process is over within two samples either way"
               : "";
  }
  void form(Reals p, ProcessShape& shape) const override {
    shape.falling_over_rising = p[0];
    shape.start += p[1];
  }
};

}  // namespace

const Effect& process_directional_lag() {
  static const DirectionalLag effect;
  return effect;
}

}  // namespace workbench::effects
