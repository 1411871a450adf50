#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "workbench/effects/common.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/effects/ringing.hpp"
#include "workbench/effects/step_response.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

constexpr Description kDescription{
    .code = "process.oscillatory",
    .title = "a process that rings by itself",
    .place = Place::kProcess,
    .view = View::kLag,
    .signature = "follows past u with a sign that changes from half cycle to half cycle",
    .cure =
        "Two storages hand on to each other: levels that slosh, a gas cushion, a "
        "cascade that is tuned too tightly within. Look there before tuning here.",
    .split = "one clear step of u in manual: does the output swing, and die out?",
};

class Oscillatory final : public Effect {
 public:
  Oscillatory() : Effect(kDescription) {}
  [[nodiscard]] SearchedParameters searched(const Situation& s) const override {
    return {{.name = "period",
             .unit = "s",
             .low = 4 * s.period_s,
             .high = s.duration_s() / 4,
             .logarithmic = true},
            {.name = "damping", .unit = "1", .low = 0.001, .high = 1, .off = 1.0}};
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    const double longest =
        std::min(s.duration_s() / 5, std::max(15 * s.first_lag_s, 60 * s.period_s));
    std::vector<Values> out;
    for (double period_s = 5 * s.period_s; period_s < longest; period_s *= 1.5) {
      for (const double damping : {0.08, 0.25, 0.6}) out.push_back({period_s, damping});
    }
    if (out.empty()) out.push_back({s.duration_s() / 5, 0.3});
    return out;
  }
  // Where u swings with one period, any process could answer as this one does, unless it
  // explains the overtones, too, and leaves next to nothing.
  [[nodiscard]] Excitation excitation(const Situation& s, Reals p) const override {
    if (swings_with(s, p[0]) && leaves_much(s)) {
      return {0, "moves of u apart from its own cycle, which has this period",
              kLeastMoves, false};
    }
    return moves_of_u(s);
  }
  [[nodiscard]] std::string evidence(const Situation&, Reals p, Reals) const override {
    const double root = std::sqrt(std::max(1 - p[1] * p[1], 1e-9));
    const double left = std::exp(-2 * std::numbers::pi * p[1] / root);
    const std::string seen = number(p[0] / root, 3);
    const std::string undamped = number(p[0], 3);
    return filled(
        seen == undamped
            ? "After every move of u the output swings with a period of {0} s, of each "
              "swing {1} % is left in the next one; the swings start with u, unlike a "
              "load's."
            : "After every move of u the output swings with a period of {0} s, which "
              "without its damping would be {2} s; of each swing {1} % is left in the "
              "next one; the swings start with u, unlike a load's.",
        {seen, number(100 * left, 2), undamped});
  }
  // A loop that rings under a load makes its process look as if it did.
  [[nodiscard]] std::string objection(const Situation& s, Reals p, Reals) const override {
    constexpr double kClear = 1.6;  // standard deviations
    if (!swings(s, p)) {
      return "after a move of u its output would not swing: a dead time beside two lags "
             "answers as smoothly";
    }
    if (is_overtone_of_u(s, p[0])) {
      return "u swings with a multiple of this period, and friction or a curve makes "
             "such overtones of a swing, too: they need steps of u to be told apart";
    }
    if (is_left_alone(s, p[0])) return "";
    const StepResponse seen =
        step_response_of(s.u, s.y, samples_within(s.period_s, p[0] / 2));
    return swing_back(seen) < kClear
               ? "seen one sample ahead, beside the past of y, its response does not "
                 "swing back: a loop that swings under a load looks the same"
               : "";
  }
  void form(Reals p, ProcessShape& shape) const override {
    shape.ring_period_s = p[0];
    shape.ring_damping = p[1];
  }

 private:
  // u mostly rests for longer than a swing to one side: nothing feeds back what swings.
  static bool is_left_alone(const Situation& s, double period_s) {
    constexpr double kMost = 0.7;  // of the samples
    std::size_t resting = 0;
    for (std::size_t k = 0; k < s.samples();) {
      std::size_t end = k + 1;
      while (end < s.samples() && s.u[end] == s.u[k]) ++end;
      if (static_cast<double>(end - k) * s.period_s > period_s / 2) resting += end - k;
      k = end;
    }
    return static_cast<double>(resting) > kMost * static_cast<double>(s.samples());
  }
  // (W30) What a short move of u calls forth comes again, or its reverse, once it has
  // gone.
  [[nodiscard]] bool swings(const Situation& s, Reals p) const {
    constexpr double kLeast = 0.043;  // of the first swing: a damping of 1/√2
    constexpr double kPerPeriod = 60;
    constexpr double kLongest = 8;  // periods: longer lags are integrators here
    ProcessShape shape;
    const double longest_s = kLongest * p[0];
    shape.first_lag_s = s.integrating ? 0 : std::min(s.first_lag_s, longest_s);
    shape.second_lag_s = std::min(s.second_lag_s, longest_s);
    form(p, shape);
    const double step_s = p[0] / kPerPeriod;
    const double time_s = 2 * (p[0] + shape.first_lag_s + shape.second_lag_s);
    const auto n = static_cast<std::size_t>(time_s / step_s);
    std::vector<double> u(n, 1.0);
    std::vector<double> answer(n);
    u.front() = 0;
    ring_behind_lags(shape, step_s, u, answer);
    std::vector<double> slope(n);
    std::adjacent_difference(answer.begin(), answer.end(), slope.begin());
    const auto peak = std::ranges::max_element(slope);
    double least = *peak;
    double swing = 0;
    for (auto at = peak; at != slope.end(); ++at) {
      least = std::min(least, *at);
      swing = std::max(swing, *at - least);
    }
    return swing > kLeast * *peak;
  }
  // Most of what u does within two such periods lies near this one.
  static bool swings_with(const Situation& s, double period_s) {
    constexpr double kMost = 0.5;    // of the variance
    constexpr double kNearby = 1.4;  // of two periods
    const std::size_t n = s.samples();
    const auto half = static_cast<std::size_t>(
        std::min(std::ceil(period_s / s.period_s), static_cast<double>(n)));
    if (n < 6 * half) return false;
    std::vector<double> fast(n - 2 * half);
    double sum = 0;
    for (std::size_t k = 0; k < 2 * half; ++k) sum += s.u[k];
    for (std::size_t k = 0; k < fast.size(); ++k) {
      fast[k] = s.u[k + half] - sum / static_cast<double>(2 * half);
      sum += s.u[k + 2 * half] - s.u[k];
    }
    const double duration_s = s.period_s * static_cast<double>(fast.size());
    double near = 0;
    const double last = duration_s * kNearby / period_s;
    for (double cycles = std::ceil(duration_s / (kNearby * period_s)); cycles <= last;
         ++cycles) {
      near += line_share(fast, s.period_s, duration_s / cycles);
    }
    return near > kMost;
  }
  static bool leaves_much(const Situation& s) {
    constexpr double kMuch = 0.1;  // of the variance of y
    const auto n = static_cast<double>(s.samples());
    double mean = 0;
    double square = 0;
    for (const double y : s.y) {
      mean += (y - s.y_low) / n;
      square += (y - s.y_low) * (y - s.y_low) / n;
    }
    return s.residual_std * s.residual_std > kMuch * (square - mean * mean);
  }
};

}  // namespace

const Effect& process_oscillatory() {
  static const Oscillatory effect;
  return effect;
}

}  // namespace workbench::effects
