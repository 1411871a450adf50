#include <algorithm>
#include <cmath>
#include <vector>

#include "workbench/effects/effects.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

constexpr Description kDescription{
    .code = "process.overflow",
    .title = "an output that is cut off above a level",
    .place = Place::kOverflow,
    .view = View::kLevel,
    .signature = "is one-sided: the model rises where the output stays flat",
    .cure =
        "Look for an overflow, a relief valve, or a transmitter at the end of its "
        "range.",
    .split = "widen the range of the sensor, or look at the overflow while it happens",
    .limits = true,
};

class Overflow final : public Effect {
 public:
  Overflow() : Effect(kDescription) {}
  [[nodiscard]] SearchedParameters searched(const Situation& s) const override {
    return {{.name = "level",
             .unit = "y",
             .low = s.y_low + 0.3 * s.y_span(),
             .high = s.y_high,
             .jumpy = true,
             .off = s.y_high,
             .resolution = s.y_span() / 1000},
            {.name = "spilling_storage", .unit = "1", .high = 2, .constant = true},
            {.name = "first_storage_brim",
             .unit = "u",
             .low = s.u_low + 0.2 * s.u_span(),
             .high = s.u_high,
             .off = s.u_high,
             .optional = true},
            {.name = "spill_share",
             .unit = "1",
             .low = 0,
             .high = 1,
             .off = 1.0,
             .optional = true}};
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    std::vector<Values> out;
    for (const double share : {0.995, 0.97, 0.93, 0.87, 0.8, 0.7, 0.6}) {
      const double level = quantile(s.y, share);
      if (level < s.y_low + 0.3 * s.y_span()) continue;
      for (const double storage : {0.0, 1.0})
        out.push_back({level, storage, s.u_high, 1});
      if (s.second_lag_s > 0) out.push_back({level, 2, s.u_high, 1});
    }
    if (s.second_lag_s > 0 && !s.integrating) {
      for (const double share : {0.4, 0.5, 0.6, 0.7, 0.85}) {
        for (const double spilled : {0.5, 1.0}) {
          out.push_back({s.y_high, 1, s.u_low + share * s.u_span(), spilled});
        }
      }
    }
    if (out.empty()) out.push_back({s.y_high, 0, s.u_high, 1});
    return out;
  }
  [[nodiscard]] Excitation excitation(const Situation& s, Reals p) const override {
    // A switch that goes off at a level is a thermostat.
    if (takes_two_values(s) && !is_asked_for_more(s, p[0])) {
      return {0, "stays of the output at the level while u asks for more", kLeastMoves,
              false};
    }
    // The simulated output: peaks of the noise are no overflow.
    std::vector<double> output(s.y.begin(), s.y.end());
    for (std::size_t k = 0; k < s.residual.size(); ++k) output[k] -= s.residual[k];
    const double reach = std::min(2 * s.residual_std, s.y_span() / 20);
    const int unanswered = own_test(s, p) ? count_unanswered(s, p[0] - reach) : 0;
    const int stays =
        count_stays(output, p[0] - s.y_span() / 100, true, memory_of(s)) + unanswered;
    const int spills = p[2] < s.u_high ? count_stays(s.u, p[2], true, memory_of(s)) : 0;
    return {std::max(stays, spills), "separate stays of the output at the level",
            kLeastMoves};
  }
  [[nodiscard]] std::string evidence(const Situation& s, Reals p, Reals) const override {
    if (p[2] < s.u_high) {
      return filled(
          "The first of two storages is full where u stays above {0}: of what comes on "
          "top, {1} % spills into the second at once.",
          {number(p[2], 4), number(100 * p[3], 3)});
    }
    return filled("The output stays at {0} where u asks for more.", {number(p[0], 4)});
  }
  // A peak leaves a quarter of its samples in the upper sixteenth of any narrow band
  // below its top; where the output is held, nearly all are there.
  [[nodiscard]] std::optional<double> own_test(const Situation& s,
                                               Reals p) const override {
    constexpr double kBand = 0.002;   // of the range of y
    constexpr double kDependent = 3;  // samples that count as one
    constexpr double kConvincing = 1e-3;
    const double band = kBand * s.y_span();
    if (lattice_of(s.y).step > band || p[0] < s.y_high - s.y_span() / 20) return {};
    int top = 0;
    int near = 0;
    for (const double y : s.y) {
      top += y >= s.y_high - band;
      near += y >= s.y_high - 16 * band;
    }
    const int trials = static_cast<int>(near / kDependent);
    const int hits = static_cast<int>(top / kDependent);
    double tail = 0;
    for (int k = hits; k <= trials; ++k) {
      tail += std::exp(std::lgamma(trials + 1) - std::lgamma(k + 1) -
                       std::lgamma(trials - k + 1) + k * std::log(0.25) +
                       (trials - k) * std::log(0.75));
    }
    if (tail > kConvincing) return {};
    return tail;
  }
  [[nodiscard]] std::string objection(const Situation& s, Reals p, Reals) const override {
    const bool holds = p[2] >= s.u_high && is_setpoint(s, p[0]);
    return holds ? "the level is the setpoint, where a controller holds the output" : "";
  }
  void form(Reals p, ProcessShape& shape) const override {
    shape.brim = p[2];
    shape.spill_share = p[3];
  }
  // Storage 0: only the reading is cut off, the process goes on rising behind it. 1: the
  // last storage spills, so it falls as soon as the inflow does. 2: the first of two
  // does.
  [[nodiscard]] std::optional<Ceiling> ceiling(Reals p) const override {
    return Ceiling{p[0], p[1] > 0.5, p[1] > 1.5};
  }

 private:
  // Whether u stays up for some rows while the output is at the level, more than once.
  static bool is_asked_for_more(const Situation& s, double level) {
    constexpr std::size_t kRows = 4;
    const double near_u = s.u_span() / 50;
    const double near_y = s.y_span() / 100;
    int stays = 0;
    std::size_t rows = 0;
    for (std::size_t k = 0; k < s.samples(); ++k) {
      const bool asked = s.u[k] > s.u_high - near_u && s.y[k] > level - near_y;
      rows = asked ? rows + 1 : 0;
      stays += rows == kRows ? 1 : 0;
    }
    return stays >= kLeastMoves;
  }
  // Mostly, while the output is there.
  static bool is_setpoint(const Situation& s, double level) {
    if (s.sp.size() != s.samples()) return false;
    const double near = s.y_span() / 100;
    std::size_t there = 0;
    std::size_t wanted = 0;
    for (std::size_t k = 0; k < s.samples(); ++k) {
      if (s.y[k] < level - near) continue;
      ++there;
      wanted += std::abs(s.sp[k] - level) < near ? 1 : 0;
    }
    return 2 * wanted > there;
  }
  // Moves of u by an eighth of its span while the output is held at `level`: each is an
  // occasion of its own to leave.
  static int count_unanswered(const Situation& s, double level) {
    int count = 0;
    double anchor = 0;
    bool above = false;
    for (std::size_t k = 0; k < s.samples(); ++k) {
      const bool now = s.y[k] > level;
      if (now && above && std::abs(s.u[k] - anchor) > s.u_span() / 8) {
        ++count;
        anchor = s.u[k];
      }
      if (now && !above) anchor = s.u[k];
      above = now;
    }
    return count;
  }
};

}  // namespace

const Effect& process_overflow() {
  static const Overflow effect;
  return effect;
}

}  // namespace workbench::effects
