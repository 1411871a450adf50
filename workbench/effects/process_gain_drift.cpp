#include <algorithm>

#include "workbench/effects/common.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

constexpr Description kDescription{
    .code = "process.gain_drift",
    .title = "a gain that drifts",
    .place = Place::kProcess,
    .view = View::kTime,
    .signature = "follows u with a factor that grows over the recording",
    .cure =
        "Look for fouling, catalyst ageing or a drifting supply; retune or schedule "
        "the gain.",
    .split = "repeat the same step of u early and late",
    .bends = true,
};

class GainDrift final : public Effect {
 public:
  GainDrift() : Effect(kDescription) {}
  [[nodiscard]] SearchedParameters searched(const Situation& s) const override {
    return {{.name = "middle",
             .unit = "s",
             .high = s.duration_s(),
             .constant = true,
             .instant = true}};
  }
  [[nodiscard]] std::span<const SolvedParameter> solved() const override {
    static constexpr SolvedParameter kSolved[] = {{"drift", "y/u/s"},
                                                  {"drift_at_zero_u", "y/s", false}};
    return kSolved;
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    return {{0.5 * s.duration_s()}};
  }
  [[nodiscard]] Excitation excitation(const Situation& s, Reals) const override {
    const std::size_t half = s.samples() / 2;
    const double size = s.u_span() / 8;
    return {2 * std::min(count_moves(s.u.first(half), size),
                         count_moves(s.u.subspan(half), size)),
            "moves of u, early and late", 2 * kLeastMoves};
  }
  [[nodiscard]] std::string evidence(const Situation& s, Reals, Reals c) const override {
    return filled(
        "The same move of u has another effect late than early: the gain changes by {0} "
        "y/u over the recording.",
        {number(c[0] * s.duration_s(), 3)});
  }
  // What ages or fouls does so over days.
  [[nodiscard]] std::string cure(const Situation& s, Reals p) const override {
    return s.duration_s() < kDay_s
               ? "Look for what changes within the recording: a supply whose pressure or "
                 "temperature drifts, or something that warms up; record again once it "
                 "rests, or schedule the gain."
               : Effect::cure(s, p);
  }
  [[nodiscard]] std::string objection(const Situation& s, Reals, Reals c) const override {
    const double pivot = c[0] != 0 ? -c[1] / c[0] : s.u_high + 2 * s.u_span();
    const bool near =
        pivot >= std::min(0.0, s.u_low - s.u_span()) && pivot <= s.u_high + s.u_span();
    return near ? "" : "the u at which such a drift leaves y alone is far off its range";
  }
  void load(Reals p, const LoadSetting& setting, Columns columns) const override {
    for (std::size_t k = 0; k < setting.z.size(); ++k) {
      const double time =
          setting.start_s + static_cast<double>(k) * setting.period_s - p[0];
      columns[0][k] = setting.z[k] * time;
      columns[1][k] = time;
    }
  }
};

}  // namespace

const Effect& process_gain_drift() {
  static const GainDrift effect;
  return effect;
}

}  // namespace workbench::effects
