#include <algorithm>
#include <cmath>

#include "workbench/effects/effects.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

class Step final : public Effect {
 public:
  [[nodiscard]] const Description& description() const override {
    static constexpr Description kDescription{
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
    return kDescription;
  }
  [[nodiscard]] std::vector<SearchedParameter> searched(
      const Situation& s) const override {
    return {
        {.name = "time", .unit = "s", .low = 0, .high = s.duration_s(), .jumpy = true},
        {.name = "lag",
         .unit = "s",
         .low = 0,
         .high = s.duration_s() / 10,
         .jumpy = true}};
  }
  [[nodiscard]] std::span<const SolvedParameter> solved() const override {
    static constexpr SolvedParameter kSolved[] = {{"amplitude", "y"}};
    return kSolved;
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    std::vector<Values> out;
    for (const std::size_t at : likely_changes(s)) {
      const double time = (static_cast<double>(at) - 0.5) * s.period_s;
      const double lag_s = std::min(s.first_lag_s, s.duration_s() / 5);
      out.push_back({time, 0});
      out.push_back({time, lag_s});
      out.push_back({std::max(0.0, time - lag_s), lag_s});
    }
    return out;
  }
  [[nodiscard]] Excitation excitation(const Situation& s,
                                      std::span<const double> p) const override {
    const double shorter = std::min(p[0], s.duration_s() - p[0]);
    return {static_cast<int>(50 * shorter / s.duration_s()),
            "fiftieths of the recording on the shorter side of the change"};
  }
  [[nodiscard]] std::string evidence(const Situation&, std::span<const double> p,
                                     std::span<const double> c) const override {
    return "At t = " + number(p[0], 4) + " s the output shifts by " + number(c[0], 3) +
           " y for good, and u does not cause it.";
  }
  void load(std::span<const double> p, const LoadSetting& setting,
            Columns columns) const override {
    const double a = p[1] > 0 ? std::exp(-setting.period_s / p[1]) : 0;
    double left = -1;
    for (std::size_t k = 0; k < columns[0].size(); ++k) {
      const double since = static_cast<double>(k) * setting.period_s - p[0];
      if (since < 0) {
        columns[0][k] = 0;
        continue;
      }
      left = left < 0 ? (p[1] > 0 ? std::exp(-since / p[1]) : 0) : left * a;
      columns[0][k] = 1 - left;
    }
  }
};

}  // namespace

const Effect& disturbance_step() {
  static const Step effect;
  return effect;
}

}  // namespace workbench::effects
