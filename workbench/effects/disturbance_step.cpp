#include <algorithm>
#include <cmath>

#include "workbench/effects/common.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/effects/level_changes.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

// True where u makes one of its few great jumps within 2 % of the recording of `time_s`.
bool u_jumps_near(const Situation& s, double time_s) {
  constexpr double kGreat = 0.25;  // of the span of u
  constexpr double kNear = 0.02;   // of the recording
  constexpr int kFew = 10;
  int jumps = 0;
  bool near = false;
  for (std::size_t k = 1; k < s.samples(); ++k) {
    if (std::abs(s.u[k] - s.u[k - 1]) < kGreat * s.u_span()) continue;
    ++jumps;
    const double apart_s = static_cast<double>(k) * s.period_s - time_s;
    near = near || std::abs(apart_s) < kNear * s.duration_s();
  }
  return near && jumps <= kFew;
}

constexpr Description kDescription{
    .code = "disturbance.step",
    .title = "a sudden load change",
    .place = Place::kLoad,
    .view = View::kTime,
    .signature = "has one level before an instant and another after it",
    .cure =
        "Look in the logs for what changed then: a feed, a parallel unit, a manual "
        "valve.",
    .split = "record longer on both sides of the change, with u at rest",
    .needs_u = false,
};

class Step final : public Effect {
 public:
  Step() : Effect(kDescription) {}
  [[nodiscard]] std::vector<SearchedParameter> searched(
      const Situation& s) const override {
    return {{.name = "time",
             .unit = "s",
             .low = 0,
             .high = s.duration_s(),
             .jumpy = true,
             .instant = true,
             .sudden = true},
            {.name = "through_process", .unit = "1", .high = 1, .constant = true}};
  }
  [[nodiscard]] std::span<const SolvedParameter> solved() const override {
    static constexpr SolvedParameter kSolved[] = {{"amplitude", "y"}};
    return kSolved;
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    std::vector<Values> out;
    for (const std::size_t at : level_changes(s)) {
      const double time = (static_cast<double>(at) - 0.5) * s.period_s;
      const double lag_s = std::min(s.first_lag_s, s.duration_s() / 5);
      std::size_t first = at;
      std::size_t last = at;
      while (first > 0 && !s.estimation[first - 1]) --first;
      while (last < s.samples() && !s.estimation[last]) ++last;
      // Within a gap of the fitted samples neither the instant nor the way into the
      // output shows: both are looked for once a place there is found to be the best.
      const double gap_s = s.period_s * static_cast<double>(last - first);
      if (first == last) out.push_back({time, 0});
      for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        out.push_back({s.period_s * static_cast<double>(first) + share * gap_s, 1});
        out.push_back({std::max(0.0, time - 2 * share * lag_s), 1});
      }
    }
    return out;
  }
  [[nodiscard]] Excitation excitation(const Situation& s,
                                      std::span<const double> p) const override {
    const double shorter = std::min(p[0], s.duration_s() - p[0]);
    return {static_cast<int>(50 * shorter / s.duration_s()),
            "fiftieths of the recording on the shorter side of the change"};
  }
  [[nodiscard]] std::string evidence(const Situation& s, std::span<const double> p,
                                     std::span<const double> c) const override {
    return filled(
        u_jumps_near(s, p[0])
            ? "At t = {0} the output shifts by {1} y for good. u jumps then, too: the "
              "process may also answer that move otherwise than the model thinks."
            : "At t = {0} the output shifts by {1} y for good, and u does not cause it.",
        {s.when(p[0]), number(c[0], 3)});
  }
  [[nodiscard]] double noise_test(const Situation& s, std::span<const double> p,
                                  std::span<const double> c) const override {
    constexpr double kPlaces = 20;  // times of the change that the search tells apart
    return load_by_chance(s.residual, load_of(*this, s, p, c[0]), kPlaces);
  }
  // (W3) At the output at once, or at the input of the process, which answers as to u.
  void load(std::span<const double> p, const LoadSetting& setting,
            Columns columns) const override {
    const std::span<double> column = columns[0];
    const double h = setting.period_s;
    const double time = p[0] - setting.start_s;
    if (p[1] < 0.5) {
      for (std::size_t k = 0; k < column.size(); ++k) {
        column[k] = static_cast<double>(k) * h < time ? 0 : 1;
      }
      return;
    }
    ProcessShape shape;
    shape.first_lag_s = setting.shape.first_lag_s;
    shape.second_lag_s = setting.shape.second_lag_s;
    shape.integrating = setting.shape.integrating;
    std::vector<double> arriving(column.size());
    for (std::size_t k = 0; k < column.size(); ++k) {
      arriving[k] = std::clamp(static_cast<double>(k) + 1 - time / h, 0.0, 1.0);
    }
    std::vector<double> scratch;
    respond(shape, h, arriving, scratch, column);
  }
};

}  // namespace

const Effect& disturbance_step() {
  static const Step effect;
  return effect;
}

}  // namespace workbench::effects
