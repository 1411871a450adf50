#include <algorithm>
#include <cmath>
#include <vector>

#include "workbench/effects/effects.hpp"
#include "workbench/effects/holds.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

constexpr Description kDescription{
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

class Sticking final : public Effect {
 public:
  Sticking() : Effect(kDescription) {}
  [[nodiscard]] SearchedParameters searched(const Situation& s) const override {
    const double most = std::max(s.y_span(), 1e-12);
    return {{.name = "band",
             .unit = "y",
             .high = most,
             .constant = true,
             .within_factor = 1.25},
            {.name = "held_share", .unit = "1", .high = 1, .constant = true, .off = 0.0},
            {.name = "shortest_freeze",
             .unit = "s",
             .high = s.duration_s(),
             .constant = true}};
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    const Holder holder = who_holds(s.u, s.y);
    if (holder == Holder::kNobody) {
      const Frozen frozen = frozen_in(s.u, s.y);
      const double share =
          static_cast<double>(frozen.samples) / static_cast<double>(s.samples());
      if (frozen.least == 0 || are_filled_in(s, share)) return {};
      return {{0, share, (static_cast<double>(frozen.least) - 0.5) * s.period_s}};
    }
    if (holder == Holder::kHistorian) return {};
    const double same = same_reading(s.y_low, s.y_high);
    const std::size_t refreshed = s.filled_share > 0 ? 3 : 2;  // one of them filled in
    if (is_scanned_slowly(s.y, same, refreshed)) return {};
    const Held held = held_in(s.y, same);
    if (are_filled_in(s, held.share)) return {};
    return {{held.least_jump, held.share, 0}};
  }
  [[nodiscard]] Excitation excitation(const Situation& s, Reals p) const override {
    if (is_frozen(p)) {
      return {static_cast<int>(stretches(s, p).size()), "stretches that stand still", 1};
    }
    const Held held = held_in(s.y, same_reading(s.y_low, s.y_high));
    return {static_cast<int>(held.jumps), "jumps of the reading"};
  }
  [[nodiscard]] std::string evidence(const Situation& s, Reals p, Reals) const override {
    if (is_frozen(p)) return evidence_of_frozen(s, p);
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
  [[nodiscard]] std::optional<double> own_test(const Situation&, Reals) const override {
    return 1e-12;
  }
  // Where the reading is frozen it is left out: nothing is to be explained there.
  void record(Reals p, const Situation& s, std::span<double> y) const override {
    if (!is_frozen(p)) {
      hold_like(s.y, same_reading(s.y_low, s.y_high), y);
      return;
    }
    for (const SampleRange& range : stretches(s, p)) {
      std::copy(s.y.begin() + static_cast<std::ptrdiff_t>(range.first),
                s.y.begin() + static_cast<std::ptrdiff_t>(range.last),
                y.begin() + static_cast<std::ptrdiff_t>(range.first));
    }
  }
  bool record_part(Reals p, const Situation& s, std::span<double> part) const override {
    if (!is_frozen(p)) return Effect::record_part(p, s, part);
    for (const SampleRange& range : stretches(s, p)) {
      std::fill(part.begin() + static_cast<std::ptrdiff_t>(range.first),
                part.begin() + static_cast<std::ptrdiff_t>(range.last), 0.0);
    }
    return true;
  }

 private:
  static bool is_frozen(Reals p) { return p[2] > 0; }

  static std::vector<SampleRange> stretches(const Situation& s, Reals p) {
    const auto least = static_cast<std::size_t>(
        std::min(std::ceil(p[2] / s.period_s), static_cast<double>(s.samples() + 1)));
    return standing_still(s.y, least, s.y_low, s.y_high);
  }

  static std::string evidence_of_frozen(const Situation& s, Reals p) {
    const std::vector<SampleRange> found = stretches(s, p);
    if (found.empty()) return {};
    const SampleRange& longest =
        *std::ranges::max_element(found, [](const SampleRange& a, const SampleRange& b) {
          return a.last - a.first < b.last - b.first;
        });
    const auto at = [&s](std::size_t k) {
      return s.when(static_cast<double>(k) * s.period_s);
    };
    return filled(
        found.size() == 1
            ? "Elsewhere noise moves the reading from sample to sample, but from t = {0} "
              "to {1} it repeats to the last digit: it was frozen. These {3} samples are "
              "left out of the fit."
            : "Elsewhere noise moves the reading from sample to sample, but {2} times, "
              "longest from t = {0} to {1}, it repeats to the last digit: it was frozen. "
              "These {3} samples are left out of the fit.",
        {at(longest.first), at(longest.last - 1), std::to_string(found.size()),
         std::to_string(samples_in(found))});
  }
};

}  // namespace

const Effect& sensor_sticking() {
  static const Sticking effect;
  return effect;
}

}  // namespace workbench::effects
