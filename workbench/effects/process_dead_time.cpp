#include <algorithm>
#include <cmath>
#include <vector>

#include "workbench/effects/common.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

constexpr Description kDescription{
    .code = "process.dead_time",
    .title = "dead time",
    .place = Place::kProcess,
    .view = View::kLag,
    .signature =
        "follows the change of u, one sign at short lags and the other at longer "
        "ones",
    .cure =
        "Look for transport: long pipes, a distant analyser, a slow scan. Shorten it "
        "or tune for it.",
    .split =
        "one fast and one slow stroke: dead time loses seconds, backlash loses "
        "travel of u",
};

// Of the flow at the ends of u: a trim passes at most fifty times as much fully open as
// at its seat, and u is at most fully open at its highest.
double most_ratio(const Situation& s) {
  constexpr double kMost = 10;
  constexpr double kTrim = 50;
  const double opens = s.u_high > 0 ? std::min(s.u_span() / s.u_high, 1.0) : 1;
  return std::min(std::pow(kTrim, opens), kMost);
}

enum : std::size_t { kTime, kByFlow, kRatio, kFrom, kTo };

bool by_flow(Reals p) {
  return p[kByFlow] > 0.5;
}

// Flow at `u` over that halfway between the ends, straight between them.
double flow_at(Reals p, double u) {
  constexpr double kLeast = 0.02;
  const double share = p[kTo] > p[kFrom] ? (u - p[kFrom]) / (p[kTo] - p[kFrom]) : 0.5;
  return std::max(2 * std::lerp(1.0, p[kRatio], share) / (1 + p[kRatio]), kLeast);
}

// (W29) What leaves a pipe of constant content that moves on with the flow.
class Pipe {
 public:
  // `content` in samples at the flow halfway.
  Pipe(Reals p, std::span<const double> v, double content)
      : first_(v.front()), content_(content), passed_(v.size() + 1), carried_(passed_) {
    for (std::size_t k = 0; k < v.size(); ++k) {
      const double flow = flow_at(p, v[k]);
      passed_[k + 1] = passed_[k] + flow;
      carried_[k + 1] = carried_[k] + flow * v[k];
    }
  }
  // Mean over the interval that follows sample k; k rises from call to call.
  double operator()(std::size_t k) {
    const double flow = passed_[k + 1] - passed_[k];
    const double before = left_by(passed_[k] - content_);
    return (left_by(passed_[k + 1] - content_) - before) / flow;
  }

 private:
  // What has left once `passed` of what entered since the start has.
  double left_by(double passed) {
    if (passed <= 0) return first_ * passed;
    while (passed_[at_ + 1] < passed) ++at_;
    while (at_ > 0 && passed_[at_] > passed) --at_;
    const double share = (passed - passed_[at_]) / (passed_[at_ + 1] - passed_[at_]);
    return std::lerp(carried_[at_], carried_[at_ + 1], share);
  }

  double first_;
  double content_;
  std::vector<double> passed_;   // until each sample
  std::vector<double> carried_;  // the same, times what it carried
  std::size_t at_ = 0;
};

class DeadTime final : public ShownByMoves {
 public:
  DeadTime() : ShownByMoves(kDescription) {}
  [[nodiscard]] SearchedParameters searched(const Situation& s) const override {
    return {{.name = "dead_time",
             .unit = "s",
             .low = 0,
             .high = s.duration_s() / 10,
             .off = 0.0,
             .resolution = s.period_s / 20},
            {.name = "by_flow", .unit = "1", .high = 1, .constant = true},
            {.name = "flow_ratio",
             .unit = "1",
             .low = 1 / most_ratio(s),
             .high = most_ratio(s),
             .logarithmic = true,
             .only_with = "by_flow"},
            level_of_u(s, "flow_from"),
            level_of_u(s, "flow_to")};
  }
  [[nodiscard]] OptionalForm optional_form() const override {
    static constexpr std::string_view kByFlowOnly[] = {"by_flow", "flow_ratio",
                                                       "flow_from", "flow_to"};
    return {"by_flow", kByFlowOnly};
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    constexpr double kShows = 1.5;  // a ratio below is a dead time like any other
    std::vector<Values> out;
    const double longest =
        std::min(s.duration_s() / 10, std::max(4 * s.first_lag_s, 30 * s.period_s));
    const auto add = [&](double time_s, bool follows, double ratio) {
      out.push_back({time_s, follows ? 1.0 : 0.0, ratio, s.u_low, s.u_high});
    };
    for (double time = s.period_s; time <= longest; time *= 1.6) add(time, false, 1);
    if (out.empty()) add(longest, false, 1);
    const double ratio = std::min(3.0, most_ratio(s));
    if (ratio < kShows) return out;
    for (double time = 3 * s.period_s; time <= longest; time *= 1.8) {
      add(time, true, ratio);
      add(time, true, 1 / ratio);
    }
    return out;
  }
  [[nodiscard]] std::string evidence(const Situation& s, Reals p, Reals) const override {
    if (by_flow(p)) {
      return filled(
          "Moves of u reach the output {0} s late around u = {1} and {2} s late around "
          "u = {3}, as through a pipe whose flow follows u.",
          {number(p[kTime] / flow_at(p, p[kFrom]), 3), number(p[kFrom], 3),
           number(p[kTime] / flow_at(p, p[kTo]), 3), number(p[kTo], 3)});
    }
    std::string said =
        filled("Every move of u reaches the output {0} s late, fast and slow ones alike.",
               {number(p[kTime], 3)});
    if (p[kTime] < s.period_s) {
      said +=
          " It is shorter than a row: a log that reads u somewhat before it acts does as "
          "much.";
    }
    return said;
  }
  // Through a pipe whose flow changes, before the lags.
  void move(Reals p, ValveSignal& signal) const override {
    if (!by_flow(p) || signal.v.empty()) return;
    Pipe pipe(p, signal.v, p[kTime] / signal.period_s);
    for (std::size_t k = 0; k < signal.v.size(); ++k) signal.v[k] = pipe(k);
  }
  void form(Reals p, ProcessShape& shape) const override {
    if (!by_flow(p)) shape.dead_time_s = p[kTime];
  }
};

}  // namespace

const Effect& process_dead_time() {
  static const DeadTime effect;
  return effect;
}

}  // namespace workbench::effects
