#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "workbench/effects/effects.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

// A function on a table: its values and slopes, a step of the table wide.
struct Knot {
  double value;
  double slope;
};
// The cubic from one knot to the next.
struct Cubic {
  double value;
  double slope;
  double bend;
  double twist;
};
template <std::size_t N>
std::array<Cubic, N - 1> joined(const std::array<Knot, N>& knots) {
  std::array<Cubic, N - 1> out;
  for (std::size_t i = 0; i + 1 < N; ++i) {
    const Knot& a = knots[i];
    const Knot& b = knots[i + 1];
    const double rise = b.value - a.value;
    out[i] = {a.value, a.slope, 3 * rise - 2 * a.slope - b.slope,
              a.slope + b.slope - 2 * rise};
  }
  return out;
}
// `place` in steps of the table, whose ends go on; of a simulation that runs away it may
// be any number or none.
inline double off_table(std::span<const Cubic> cubics, double place) {
  const std::size_t last = cubics.size() - 1;
  std::size_t i = 0;
  if (!(place < static_cast<double>(last))) {
    i = last;
  } else if (place > 0) {
    i = static_cast<std::size_t>(place);
  }
  const double t = place - static_cast<double>(i);
  const Cubic& at = cubics[i];
  return at.value + t * (at.slope + t * (at.bend + t * at.twist));
}

// Mean of a rounded value, over its nearest level, where normal noise of less than 0.09
// steps goes before the rounding: only the nearer edge matters. `off`: of the value from
// that level, -0.5 to 0.5.
class SharpStairs {
 public:
  explicit SharpStairs(double noise)
      : softness_(noise * std::numbers::sqrt2), tail_(tail()) {}

  double operator()(double off) const {
    const double from_edge = (0.5 - std::abs(off)) / softness_;
    return std::copysign(off_table(tail_, std::min(from_edge, kEnd) * kPerUnit), off);
  }

 private:
  static constexpr std::size_t kPerUnit = 64;
  static constexpr double kEnd = 4;  // beyond it nothing

  // Upper tail of the normal distribution of variance 1/2, to 1e-9.
  static constexpr std::size_t kCubics = static_cast<std::size_t>(kEnd) * kPerUnit;
  static const std::array<Cubic, kCubics>& tail() {
    static const std::array<Cubic, kCubics> cubics = [] {
      std::array<Knot, kCubics + 1> out;
      for (std::size_t i = 0; i < out.size(); ++i) {
        const double x = static_cast<double>(i) / kPerUnit;
        out[i] = {std::erfc(x) / 2,
                  -std::exp(-x * x) * std::numbers::inv_sqrtpi / kPerUnit};
      }
      return joined(out);
    }();
    return cubics;
  }

  double softness_;
  std::span<const Cubic> tail_;
};

// The same of more noise: the waves that rounding leaves on a straight line, as its
// Fourier series has them, (-1)^k / (pi k) exp(-2 (pi k noise)^2) sin(2 pi k off).
class BlurredStairs {
 public:
  explicit BlurredStairs(double noise) : noise_(noise) {
    std::array<Knot, kPoints + 1> knots{};
    constexpr double kPi = std::numbers::pi;
    constexpr int kWaves = 10;  // the next has 1e-9 of a step
    const auto& circle = sines();
    for (int k = 1; k <= kWaves; ++k) {
      const double damped = std::exp(-2 * kPi * kPi * k * k * noise * noise);
      const double wave = (k % 2 == 0 ? 1 : -1) * damped / (kPi * k);
      const double steepness = 2 * kPi * k / kPoints;
      for (std::size_t i = 0; i <= kPoints; ++i) {
        // off runs from -0.5 to 0.5: half a turn behind i.
        const std::size_t at = (i + kPoints / 2) * static_cast<std::size_t>(k) % kPoints;
        knots[i].value += wave * circle[at];
        knots[i].slope += wave * steepness * circle[(at + kPoints / 4) % kPoints];
      }
    }
    cubics_ = joined(knots);
  }

  // Of the same noise many runs follow each other. Valid until the next call of a thread.
  static const BlurredStairs& of(double noise) {
    thread_local BlurredStairs last(noise);
    if (last.noise_ != noise) last = BlurredStairs(noise);
    return last;
  }

  double operator()(double off) const {
    return off + off_table(cubics_, (off + 0.5) * kPoints);
  }

 private:
  static constexpr std::size_t kPoints = 256;

  static const std::array<double, kPoints>& sines() {
    static const auto values = [] {
      std::array<double, kPoints> out;
      for (std::size_t i = 0; i < kPoints; ++i) {
        out[i] = std::sin(2 * std::numbers::pi * static_cast<double>(i) / kPoints);
      }
      return out;
    }();
    return values;
  }

  double noise_;
  std::array<Cubic, kPoints> cubics_;
};

constexpr Description kDescription{
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

class Quantisation final : public Effect {
 public:
  Quantisation() : Effect(kDescription) {}
  [[nodiscard]] SearchedParameters searched(const Situation& s) const override {
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
  [[nodiscard]] Excitation excitation(const Situation& s, Reals p) const override {
    int changes = 0;
    for (std::size_t k = 1; k < s.samples(); ++k) {
      changes += std::abs(s.y[k] - s.y[k - 1]) > 0.5 * p[0];
    }
    return {changes, "changes between levels"};
  }
  [[nodiscard]] std::string evidence(const Situation& s, Reals p, Reals) const override {
    return filled("All values of the output lie on {0} levels, {1} y apart.",
                  {std::to_string(lattice_of(s.y).levels), number(p[0], 3)});
  }
  // Values fall on a lattice or they do not. One too fine to matter beside the noise and
  // the moves of y is how the file was written.
  [[nodiscard]] std::optional<double> own_test(const Situation& s,
                                               Reals p) const override {
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
  void record(Reals p, const Situation&, std::span<double> y) const override {
    const double noise = std::max(p[2] / p[0], 0.02);
    if (noise < kBlurred) {
      record_as(SharpStairs(noise), p, y);
    } else if (noise < kLost) {
      record_as(BlurredStairs::of(noise), p, y);
    }
  }

 private:
  // Noise in steps: from here on edges reach each other; from here on no stair is left.
  static constexpr double kBlurred = 0.09;
  static constexpr double kLost = 1;

  template <class Stairs>
  static void record_as(const Stairs& stairs, Reals p, std::span<double> y) {
    for (double& value : y) {
      const double place = (value - p[1]) / p[0];
      const double nearest = std::floor(place + 0.5);
      value = p[1] + p[0] * (nearest + stairs(place - nearest));
    }
  }
};

}  // namespace

const Effect& sensor_quantisation() {
  static const Quantisation effect;
  return effect;
}

}  // namespace workbench::effects
