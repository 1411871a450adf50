#include <algorithm>
#include <cmath>
#include <utility>

#include "workbench/effects/common.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

constexpr Description kDescription{
    .code = "process.nonlinear_gain",
    .title = "a gain that depends on the operating point",
    .place = Place::kProcess,
    .view = View::kLevel,
    .signature = "bends with the level of the process, rising and falling alike",
    .cure = "Schedule the controller gain over the operating point.",
    .harmless = true,
    .split =
        "repeat the same step of u at several operating points, and log the stem "
        "position",
    .bends = true,
};

class NonlinearGain final : public ShownByMoves {
 public:
  NonlinearGain() : ShownByMoves(kDescription) {}
  [[nodiscard]] SearchedParameters searched(const Situation& s) const override {
    // Over a tank that runs nearly empty the slope changes a thousandfold.
    constexpr double kMost = 7;
    auto parameters = curve_parameters(s);
    parameters[0].low = -kMost;
    parameters[0].high = kMost;
    parameters.push_back(
        {.name = "lag_follows_gain", .unit = "1", .high = 4, .constant = true});
    parameters.push_back({.name = "storage_start",
                          .unit = "u",
                          .low = -s.u_span(),
                          .high = s.u_span(),
                          .initial = true});
    return parameters;
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    if (s.integrating) return {};
    std::vector<Values> out;
    // A tank that runs nearly empty at one end bends the more than its curvature says.
    constexpr double kByHead = 2;
    const auto [low, high] = reached(s);
    for (const Values& start : curve_starts(s)) {
      for (const double follows : {0.0, 1.0, 2.0, 3.0, 4.0}) {
        if (follows > 2 && !(s.second_lag_s > 0)) continue;
        out.push_back({start[0], low, high, follows, 0});
        if (by_head(out.back())) out.back()[0] *= kByHead;
      }
    }
    return out;
  }
  [[nodiscard]] std::string evidence(const Situation&, Reals p, Reals) const override {
    const std::string_view said =
        by_head(p)
            ? "The process answers {0} times as strongly at the {1} end of its range as "
              "at the other, as tanks do that drain by their own head."
        : p[3] > 0.5
            ? "The process answers {0} times as strongly at the {1} end of its range "
              "as at the other, and as much more slowly."
            : "The process answers {0} times as strongly at the {1} end of its range "
              "as at the other.";
    return filled(said,
                  {number(std::exp(std::abs(p[0])), 3), p[0] > 0 ? "upper" : "lower"});
  }
  // Order shows in the transients alone.
  [[nodiscard]] std::string objection(const Situation& s, Reals p, Reals) const override {
    constexpr double kSeen = 2;  // samples that the transients of a lag last, at least
    const bool is_static = p[3] < 0.5 && !s.integrating &&
                           s.first_lag_s + s.second_lag_s < kSeen * s.period_s;
    return is_static
               ? "the process is over within two samples, so that a curve behind it "
                 "cannot be told from one of the valve"
               : "";
  }
  // A tank does not drain below its bottom.
  [[nodiscard]] bool ends_there(Reals p) const override { return by_head(p); }
  // 0: a curve behind linear dynamics. 1: storages with a curved outflow. 2: tanks that
  // drain by their own head. 3, 4: the same, of two storages only the last.
  void form(Reals p, ProcessShape& shape) const override {
    if (p[3] > 0.5) shape.storage = curve(p);
    shape.last_only = p[3] > 2.5;
    shape.start += p[4];
  }
  void bend(Reals p, std::span<double> z) const override { curve(p).bend(z); }

 private:
  // The range of the storages: what u comes to behind the lags.
  static std::pair<double, double> reached(const Situation& s) {
    std::vector<double> level(s.samples());
    lag(s.u, s.period_s, s.first_lag_s, s.u[0], level);
    if (s.second_lag_s > 0) lag(level, s.period_s, s.second_lag_s, s.u[0], level);
    const auto [low, high] = std::ranges::minmax_element(level);
    return *low < *high ? std::pair(*low, *high) : std::pair(s.u_low, s.u_high);
  }
  static bool by_head(Reals p) { return (p[3] > 1.5 && p[3] < 2.5) || p[3] > 3.5; }
  static Curve curve(Reals p) { return {p[0], p[1], p[2], by_head(p)}; }
};

}  // namespace

const Effect& process_nonlinear_gain() {
  static const NonlinearGain effect;
  return effect;
}

}  // namespace workbench::effects
