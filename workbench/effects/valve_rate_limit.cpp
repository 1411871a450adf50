#include <algorithm>
#include <cmath>

#include "workbench/effects/common.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

constexpr Description kDescription{
    .code = "valve.rate_limit",
    .title = "a limited stem speed",
    .place = Place::kRate,
    .view = View::kSpeed,
    .signature = "grows while u keeps moving one way faster than the stem can",
    .cure =
        "Check air supply, boosters and tubing of the slow stroke; a leaking "
        "diaphragm shows on one stroke only. A dead time that is longer at low flow, "
        "or a process that rises faster than it falls, looks alike: watch the stem.",
    .split = "one slow and one fast stroke: a rate limit vanishes on the slow one",
    .limits = true,
};

// A slow stem may be on its way from where u was before the recording.
constexpr double kFarthestStart = 2;  // spans of u

class RateLimit final : public Effect {
 public:
  RateLimit() : Effect(kDescription) {}
  [[nodiscard]] SearchedParameters searched(const Situation& s) const override {
    const double free = free_rate(s);
    const double slowest = slowest_useful(s);
    const auto rate = [&](std::string_view name) {
      return SearchedParameter{.name = name,
                               .unit = "u/s",
                               .low = slowest,
                               .high = free,
                               .logarithmic = true,
                               .jumpy = true,
                               .off = free};
    };
    return {rate("opening_rate"), rate("closing_rate"),
            searched_stem_start(s, "slow_stem_start", kFarthestStart)};
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    const double fastest = fastest_move(s);
    const double slowest = slowest_useful(s);
    const double free = free_rate(s);
    std::vector<Values> out;
    constexpr int kGrid = 9;
    for (int i = 1; i < kGrid; ++i) {
      const double rate = fastest * std::pow(slowest / fastest, i / double{kGrid});
      out.push_back({rate, free, 0});
      out.push_back({free, rate, 0});
      out.push_back({rate, rate, 0});
    }
    return out;
  }
  [[nodiscard]] Excitation excitation(const Situation& s, Reals p) const override {
    const double reach = s.u_span() / 50;
    double x = s.u[0];
    int events = 0;
    bool behind = false;
    for (const double u : s.u) {
      x = std::clamp(u, x - p[1] * s.period_s, x + p[0] * s.period_s);
      const bool now = std::abs(u - x) > reach;
      events += now && !behind;
      behind = now || (behind && u != x);
    }
    return {events, "moves of u that leave the stem behind", kLeastMoves};
  }
  [[nodiscard]] std::string evidence(const Situation& s, Reals p, Reals) const override {
    const double fastest = fastest_move(s);
    const bool opening = p[0] < 0.95 * fastest;
    const bool closing = p[1] < 0.95 * fastest;
    const std::string up = number(p[0], 3);
    const std::string down = number(p[1], 3);
    if (opening && closing) {
      return filled(
          "While u moves fast the stem falls behind: it makes at most {0} u/s opening "
          "and {1} u/s closing.",
          {up, down});
    }
    return opening ? filled(
                         "While u moves fast the stem falls behind: it makes at most {0} "
                         "u/s opening, and closes freely.",
                         {up})
                   : filled(
                         "While u moves fast the stem falls behind: it makes at most {0} "
                         "u/s closing, and opens freely.",
                         {down});
  }
  void move(Reals p, ValveSignal& signal) const override {
    const double up = p[0] * signal.period_s;
    const double down = p[1] * signal.period_s;
    const IntervalWeight weight = signal.weight();
    const double whole = weight.ramp_down(signal.period_s);
    double x = signal.v.empty() ? 0 : signal.v[0] + p[2];
    for (double& v : signal.v) {
      const double way = v - x;
      const double reach = way > 0 ? up : down;
      const double size = std::abs(way);
      if (size <= reach) {
        x = v;
        if (reach > 0) v -= way * weight.ramp_down(signal.period_s * size / reach);
      } else {
        const double step = std::copysign(reach, way);
        x += step;
        v = x - step * whole;
      }
    }
  }

 private:
  // No sample of u asks for more: a limit there does nothing.
  static double fastest_move(const Situation& s) {
    double most = 0;
    for (std::size_t k = 1; k < s.u.size(); ++k) {
      most = std::max(most, std::abs(s.u[k] - s.u[k - 1]));
    }
    return std::max(most, 1e-9 * std::max(s.u_span(), 1e-9)) / s.period_s;
  }
  // Every move is over almost at once: where a limit is off.
  static double free_rate(const Situation& s) { return 30 * fastest_move(s); }
  // The whole recording long for one stroke.
  static double slowest_useful(const Situation& s) {
    return std::min(0.5 * fastest_move(s), s.u_span() / s.duration_s());
  }
};

}  // namespace

const Effect& valve_rate_limit() {
  static const RateLimit effect;
  return effect;
}

}  // namespace workbench::effects
