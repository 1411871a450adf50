#include <algorithm>
#include <cmath>
#include <numbers>

#include "workbench/effects/effects.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

class Quantisation final : public Effect {
 public:
  [[nodiscard]] const Description& description() const override {
    static constexpr Description kDescription{
        .code = "sensor.quantisation",
        .title = "a coarse resolution of the record",
        .place = Place::kRecord,
        .view = View::kLevel,
        .signature =
            "takes few values: the output moves in stairs that return to the same levels",
        .cure =
            "Record with a finer resolution: a narrower range of the converter, a "
            "smaller exception band of the historian.",
        .split = "record once without compression and with full resolution",
        .needs_u = false,
        .least_share = -0.1,
    };
    return kDescription;
  }
  [[nodiscard]] std::vector<SearchedParameter> searched(
      const Situation& s) const override {
    const double most = std::max(s.y_span(), 1e-12);
    return {{.name = "step", .unit = "y", .high = most, .constant = true, .off = 0.0},
            {.name = "origin",
             .unit = "y",
             .low = s.y_low,
             .high = s.y_high,
             .constant = true},
            {.name = "noise_before", .unit = "y", .low = 0, .high = most, .jumpy = true}};
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    const Lattice lattice = lattice_of(s.y);
    if (lattice.share < 0.98) return {};
    std::vector<Values> out;
    for (const double noise : {0.05, 0.15, 0.3, 0.5}) {
      out.push_back({lattice.step, s.y_low, noise * lattice.step});
    }
    return out;
  }
  [[nodiscard]] Excitation excitation(const Situation& s,
                                      std::span<const double> p) const override {
    return {count_reversals(s.y, 0.5 * p[0]), "changes between levels"};
  }
  [[nodiscard]] std::string evidence(const Situation& s, std::span<const double> p,
                                     std::span<const double>) const override {
    return filled("All values of the output lie on {0} levels, {1} y apart.",
                  {std::to_string(lattice_of(s.y).levels), number(p[0], 3)});
  }
  // Values fall on a lattice or they do not. One too fine to matter beside the noise and
  // the moves of y is how the file was written.
  [[nodiscard]] std::optional<double> own_test(const Situation& s,
                                               std::span<const double> p) const override {
    constexpr double kCoarse = 0.25;  // of the standard deviation of y
    double mean = 0;
    double square = 0;
    for (const double y : s.y) {
      mean += (y - s.y_low) / static_cast<double>(s.samples());
      square += (y - s.y_low) * (y - s.y_low) / static_cast<double>(s.samples());
    }
    const double deviation = std::sqrt(std::max(square - mean * mean, 0.0));
    return p[0] >= std::min(s.residual_std, kCoarse * deviation) ? 1e-12 : 1;
  }
  // The mean of what is recorded, when noise before the rounding decides near an edge.
  void record(std::span<const double> p, const Situation&,
              std::span<double> y) const override {
    const double softness = std::max(p[2] / p[0], 0.02) * std::numbers::sqrt2;
    for (double& value : y) {
      const double place = (value - p[1]) / p[0];
      const double nearest = std::round(place);
      double mean = nearest;
      for (int j = -2; j <= 2; ++j) {
        const double distance = (nearest + j + 0.5 - place) / softness;
        if (std::abs(distance) > 4) continue;
        mean += 0.5 * std::erfc(distance) - (j < 0 ? 1 : 0);
      }
      value = p[1] + p[0] * mean;
    }
  }
};

}  // namespace

const Effect& sensor_quantisation() {
  static const Quantisation effect;
  return effect;
}

}  // namespace workbench::effects
