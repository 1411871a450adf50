#include <algorithm>
#include <numeric>
#include <vector>

#include "workbench/effects/common.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

constexpr Description kDescription{
    .code = "disturbance.ramp",
    .title = "a slow drift",
    .place = Place::kLoad,
    .view = View::kTime,
    .signature = "has a trend that does not follow u",
    .cure =
        "Look for a slow cause: ambient temperature, fouling, a drifting "
        "transmitter.",
    .split = "calibrate the transmitter, and record longer",
    .needs_u = false,
};

// (W37) Whether u goes one way from `start_s` on, in a straight line.
bool sweeps_from(const Situation& s, double start_s) {
  constexpr double kStraight = 0.95;  // of the variance
  constexpr double kRetreat = 0.02;   // of the span of u
  const auto first = static_cast<std::size_t>(std::max(start_s, 0.0) / s.period_s);
  const std::span<const double> u = s.u.subspan(std::min(first, s.samples()));
  const auto n = static_cast<double>(u.size());
  const double mean = std::reduce(u.begin(), u.end()) / std::max(n, 1.0);
  double tt = 0;
  double tu = 0;
  double uu = 0;
  for (std::size_t k = 0; k < u.size(); ++k) {
    const double t = static_cast<double>(k) - (n - 1) / 2;
    tt += t * t;
    tu += t * (u[k] - mean);
    uu += (u[k] - mean) * (u[k] - mean);
  }
  return count_reversals(u, kRetreat * s.u_span()) == 0 && uu > 0 &&
         tu * tu > kStraight * tt * uu;
}

class Ramp final : public Effect {
 public:
  Ramp() : Effect(kDescription) {}
  [[nodiscard]] SearchedParameters searched(const Situation& s) const override {
    return {{.name = "start",
             .unit = "s",
             .low = 0,
             .high = 0.8 * s.duration_s(),
             .jumpy = true,
             .instant = true}};
  }
  [[nodiscard]] std::span<const SolvedParameter> solved() const override {
    static constexpr SolvedParameter kSolved[] = {{"slope", "y/s"}};
    return kSolved;
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    return {{0}, {0.25 * s.duration_s()}, {0.5 * s.duration_s()}};
  }
  [[nodiscard]] Excitation excitation(const Situation& s, Reals p) const override {
    return {static_cast<int>(20 * (s.duration_s() - p[0]) / s.duration_s()),
            "twentieths of the recording that drift"};
  }
  [[nodiscard]] std::string cure(const Situation& s, Reals p) const override {
    return s.duration_s() < kDay_s
               ? "Look for a slow cause: ambient temperature, something that warms up, a "
                 "drifting transmitter."
               : Effect::cure(s, p);
  }
  [[nodiscard]] std::string evidence(const Situation& s, Reals p,
                                     Reals c) const override {
    return filled(
        "From t = {0} on the output drifts by {1} y in all, and u does not cause it.",
        {s.when(p[0]), number(c[0] * (s.duration_s() - p[0]), 3)});
  }
  [[nodiscard]] std::string objection(const Situation& s, Reals p, Reals) const override {
    if (answers_lone_move(s, p[0])) {
      return "it begins behind the one move of u: a late answer to it looks the same";
    }
    return sweeps_from(s, p[0]) ? "u moves as steadily: a valve or process that answers "
                                  "less of it there looks the same"
                                : "";
  }
  [[nodiscard]] double noise_test(const Situation& s, Reals p, Reals c) const override {
    constexpr double kPlaces = 3;  // beginnings that it starts from
    return load_by_chance(s.residual, load_of(*this, s, p, c[0]), kPlaces);
  }
  // The drift of a load, which the process follows with its first lag.
  void load(Reals p, const LoadSetting& setting, Columns columns) const override {
    const double h = setting.period_s;
    for (std::size_t k = 0; k < columns[0].size(); ++k) {
      columns[0][k] = std::max(0.0, setting.start_s + static_cast<double>(k) * h - p[0]);
    }
    if (!setting.shape.integrating) {
      lag_of_lines(columns[0], h, setting.shape.first_lag_s, columns[0]);
    }
  }
};

}  // namespace

const Effect& disturbance_ramp() {
  static const Ramp effect;
  return effect;
}

}  // namespace workbench::effects
