#include <algorithm>
#include <vector>

#include "workbench/effects/effects.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

constexpr Description kDescription{
    .code = "process.slow_tail",
    .title = "an answer with a slow tail",
    .place = Place::kProcess,
    .view = View::kLag,
    .signature = "follows u long after the rest of the answer is over",
    .cure =
        "Walls, insulation or dead corners store and give back slowly. Tune for the fast "
        "part; to the controller the tail is a slow load.",
    .harmless = true,
    .split = "one clear step of u in manual, watched until the output really rests",
};

class SlowTail final : public Effect {
 public:
  SlowTail() : Effect(kDescription) {}
  [[nodiscard]] SearchedParameters searched(const Situation& s) const override {
    constexpr double kMost = 0.9;  // beyond it is a second lag
    // A tail that was not seen to end is a drift.
    constexpr double kLongest = 0.2;  // of the recording
    return {{.name = "tail_share", .unit = "1", .low = 0, .high = kMost, .off = 0.0},
            {.name = "tail_lag",
             .unit = "s",
             .low = s.period_s,
             .high = kLongest * s.duration_s(),
             .logarithmic = true}};
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    std::vector<Values> out;
    if (s.integrating) return out;
    for (const double longer : {2, 6, 18}) {
      const double lag_s =
          std::clamp(longer * s.first_lag_s, 3 * s.period_s, s.duration_s() / 10);
      for (const double share : {0.15, 0.4}) out.push_back({share, lag_s});
    }
    return out;
  }
  // Of a u that comes back before the tail has come, the tail is next to nothing.
  [[nodiscard]] Excitation excitation(const Situation& s, Reals p) const override {
    constexpr double kMoved = 0.25;  // of the range of u
    std::vector<double> stays(s.samples());
    lag(s.u, s.period_s, p[1], s.u[0], stays);
    const int events = count_moves(stays, kMoved * s.u_span());
    return {events, "moves of u that last as long as the tail", kLeastMoves, events > 0};
  }
  [[nodiscard]] std::string evidence(const Situation&, Reals p, Reals) const override {
    return filled(
        "Of the answer to a move of u {0} % comes later than the rest, with a lag of {1} "
        "s of its own.",
        {number(100 * p[0], 3), number(p[1], 3)});
  }
  [[nodiscard]] std::string objection(const Situation& s, Reals p, Reals) const override {
    constexpr double kSlower = 1.5;  // than the rest
    return p[1] < kSlower * s.first_lag_s
               ? "it is over as soon as the rest of the answer: that is a second lag"
               : "";
  }
  void form(Reals p, ProcessShape& shape) const override {
    shape.tail_share = p[0];
    shape.tail_lag_s = p[1];
  }
};

}  // namespace

const Effect& process_slow_tail() {
  static const SlowTail effect;
  return effect;
}

}  // namespace workbench::effects
