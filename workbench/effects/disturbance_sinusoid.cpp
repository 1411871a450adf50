#include <cmath>
#include <complex>
#include <numbers>

#include "workbench/effects/common.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

constexpr Description kDescription{
    .code = "disturbance.sinusoid",
    .title = "a periodic load",
    .place = Place::kLoad,
    .view = View::kFrequency,
    .signature = "has one line in its spectrum that does not follow u",
    .cure =
        "Look upstream for what cycles with this period: another loop, a compressor, "
        "a batch.",
    .split = "put the controller to manual: does the oscillation stay?",
    .needs_u = false,
};

class Sinusoid final : public Effect {
 public:
  Sinusoid() : Effect(kDescription) {}
  [[nodiscard]] SearchedParameters searched(const Situation& s) const override {
    return {{.name = "period",
             .unit = "s",
             .low = 3 * s.period_s,
             .high = s.duration_s() / 3,
             .logarithmic = true}};
  }
  [[nodiscard]] std::span<const SolvedParameter> solved() const override {
    static constexpr SolvedParameter kSolved[] = {
        {.name = "cosine", .unit = "y", .each = true},
        {.name = "sine", .unit = "y", .each = true}};
    return kSolved;
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    std::vector<Values> out;
    const double longest = static_cast<double>(s.samples()) / 4;
    for (const double period : strongest_periods(s, longest, 4)) {
      out.push_back({period * s.period_s});
    }
    return out;
  }
  [[nodiscard]] Excitation excitation(const Situation& s, Reals p) const override {
    // Beside a stem that sticks, too: what it leaves of a swing of u are overtones.
    if (is_overtone_of_u(s, p[0])) {
      return {0, "periods of a load that is no overtone of u", 5, false};
    }
    return {static_cast<int>(s.duration_s() / p[0]), "periods of the load"};
  }
  [[nodiscard]] std::string evidence(const Situation&, Reals p, Reals c) const override {
    return filled(
        "The residual swings with a period of {0} s and an amplitude of {1} y, and u "
        "does not cause it.",
        {number(p[0], 4), number(std::hypot(c[0], c[1]), 3)});
  }
  [[nodiscard]] std::string objection(const Situation& s, Reals p, Reals) const override {
    return locked_to_cycle(s, p[0]) ? "it keeps step with the cycle of u, whose edges a "
                                      "sinusoidal load would not make"
                                    : "";
  }
  [[nodiscard]] double noise_test(const Situation& s, Reals p, Reals c) const override {
    std::vector<double> load(s.samples());
    const double angle = 2 * std::numbers::pi * s.period_s / p[0];
    for (std::size_t k = 0; k < load.size(); ++k) {
      const double at = angle * static_cast<double>(k);
      load[k] = c[0] * std::cos(at) + c[1] * std::sin(at);
    }
    return swing_by_chance(s.residual, load, p[0] / s.period_s);
  }
  void load(Reals p, const LoadSetting& setting, Columns columns) const override {
    const double angle = 2 * std::numbers::pi * setting.period_s / p[0];
    const std::complex<double> turn = std::polar(1.0, angle);
    std::complex<double> w(1, 0);
    for (std::size_t k = 0; k < columns[0].size(); ++k) {
      columns[0][k] = w.real();
      columns[1][k] = w.imag();
      w *= turn;
    }
  }

 private:
  static constexpr int kOvertones = 5;

  // The output follows the overtones of u as the model's linear valve would: a setpoint
  // that moves made them. A stem that sticks would leave as much of them as it makes.
  static bool follows_edges(const Situation& s, double cycle_s) {
    constexpr double kLeft = 0.05;  // of their power
    if (s.residual.size() != s.samples()) return false;
    std::vector<double> modelled(s.y.begin(), s.y.end());
    for (std::size_t k = 0; k < modelled.size(); ++k) modelled[k] -= s.residual[k];
    double expected = 0;  // shares of the variance
    double left = 0;
    for (int k = 2; k <= kOvertones; ++k) {
      expected += line_share(modelled, s.period_s, cycle_s / k);
      left += line_share(s.residual, s.period_s, cycle_s / k);
    }
    return left * variance(s.residual) < kLeft * expected * variance(modelled);
  }
  static double variance(std::span<const double> signal) {
    const auto n = static_cast<double>(signal.size());
    double mean = 0;
    for (const double value : signal) mean += value / n;
    double sum = 0;
    for (const double value : signal) sum += (value - mean) * (value - mean);
    return sum / n;
  }

  // A limit cycle is the strongest line of u and has overtones; a load that is a pure
  // sinusoid leaves u a sinusoid, too. Locked: the period is that cycle's or an
  // overtone's.
  static bool locked_to_cycle(const Situation& s, double period_s) {
    constexpr double kDominant = 0.3;    // share of u's variance in the line
    constexpr double kOvertone = 0.006;  // of the line; a triangle has 0.012 in its third
    // Fewer of them are no limit cycle, but what the setpoint's steps happen to make.
    constexpr double kFewestCycles = 8;
    const double cycle_s = strongest_period(s.u, s.period_s);
    if (s.duration_s() < kFewestCycles * cycle_s) return false;
    const double line = line_share(s.u, s.period_s, cycle_s);
    if (line < kDominant) return false;
    double overtones = 0;
    for (int k = 2; k <= kOvertones; ++k) {
      // A line stands far out from what lies beside it.
      double beside = 0;
      for (const double aside : {-6.0, -5.0, -4.0, -3.0, 3.0, 4.0, 5.0, 6.0}) {
        const double frequency = k / cycle_s + aside / s.duration_s();
        beside += line_share(s.u, s.period_s, 1 / frequency) / 8;
      }
      const double share = line_share(s.u, s.period_s, cycle_s / k);
      if (share > 10 * beside) overtones += share;
    }
    if (overtones < kOvertone * line || follows_edges(s, cycle_s)) return false;
    const double resolution = 2 / s.duration_s();
    for (int k = 1; k <= kOvertones; ++k) {
      if (std::abs(1 / period_s - k / cycle_s) < k * resolution) return true;
    }
    return false;
  }
};

}  // namespace

const Effect& disturbance_sinusoid() {
  static const Sinusoid effect;
  return effect;
}

}  // namespace workbench::effects
