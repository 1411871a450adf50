#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "workbench/effects/effects.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

// Upper tail of the normal distribution of variance 1/2, off a table: its values and
// slopes, joined by cubics, to 1e-9.
class Tail {
 public:
  static constexpr double kEnd = 4;  // either way; beyond it 0 or 1

  double operator()(double x) const {
    const double place = (x + kEnd) * kPerUnit;
    const auto i = std::min(static_cast<std::size_t>(place), kPoints - 2);
    const double t = place - static_cast<double>(i);
    const Point& a = points_[i];
    const Point& b = points_[i + 1];
    const double rise = b.value - a.value;
    return a.value + t * (a.slope + t * (3 * rise - 2 * a.slope - b.slope +
                                         t * (a.slope + b.slope - 2 * rise)));
  }

  static const Tail& table() {
    static const Tail tail;
    return tail;
  }

 private:
  Tail() {
    for (std::size_t i = 0; i < kPoints; ++i) {
      const double x = static_cast<double>(i) / kPerUnit - kEnd;
      points_[i] = {std::erfc(x) / 2,
                    -std::exp(-x * x) * std::numbers::inv_sqrtpi / kPerUnit};
    }
  }

  static constexpr std::size_t kPerUnit = 64;
  static constexpr std::size_t kPoints = 8 * kPerUnit + 1;
  struct Point {
    double value;
    double slope;  // to the next point
  };
  std::array<Point, kPoints> points_;
};

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
    const double reach = Tail::kEnd * softness;
    const Tail& tail = Tail::table();
    for (double& value : y) {
      const double place = (value - p[1]) / p[0];
      const double nearest = std::floor(place + 0.5);
      const double off = place - nearest;
      double mean = nearest;
      for (double edge = 0.5; edge < 3 && edge - off <= reach; ++edge) {
        mean += tail((edge - off) / softness);
      }
      for (double edge = -0.5; edge > -2 && off - edge <= reach; --edge) {
        mean -= 1 - tail((edge - off) / softness);
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
