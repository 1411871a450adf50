#include <algorithm>
#include <cmath>

#include "workbench/effects/common.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/effects/level_changes.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

constexpr double kNear = 0.02;  // of the recording

bool u_jumps_near(const Situation& s, double time_s) {
  return std::ranges::any_of(great_jumps_of_u(s), [&](double jump_s) {
    return std::abs(jump_s - time_s) < kNear * s.duration_s();
  });
}

// A jump that a load calls forth from the controller comes after the load.
bool u_jumps_before(const Situation& s, double time_s) {
  return std::ranges::any_of(great_jumps_of_u(s), [&](double jump_s) {
    return jump_s > time_s - kNear * s.duration_s() && jump_s <= time_s + s.period_s;
  });
}

enum : std::size_t { kTime, kThroughProcess, kPassing, kEnd };

bool passes(Reals p) {
  return p[kPassing] > 0.5;
}

// Whether it is there at the first sample and gone before the process has forgotten how
// it began.
bool is_of_beginning(const Situation& s, Reals p) {
  constexpr double kLags = 3;
  return passes(p) && p[kTime] < kNear * s.duration_s() &&
         p[kEnd] < kLags * (s.first_lag_s + s.second_lag_s);
}

// Of its size, what the output has come to by the end of the load or of the recording.
double share_reached(const Situation& s, Reals p) {
  if (p[kThroughProcess] < 0.5 || !(s.first_lag_s > 0)) return 1;
  const double lasts = (passes(p) ? p[kEnd] : s.duration_s()) - p[kTime];
  return 1 - std::exp(-std::max(lasts, 0.0) / s.first_lag_s);
}

// How much of a unit load has come by a time, sample by sample: at once, or the share of
// the interval before the sample.
void add_change(double samples, bool at_once, double by, std::span<double> column) {
  for (std::size_t k = 0; k < column.size(); ++k) {
    const double since = static_cast<double>(k) - samples;
    column[k] += by * (at_once ? (since < 0 ? 0 : 1) : std::clamp(since + 1, 0.0, 1.0));
  }
}

constexpr Description kDescription{
    .code = "disturbance.step",
    .title = "a sudden load change",
    .place = Place::kLoad,
    .view = View::kTime,
    .signature = "has one level before an instant and another after it, or for a while",
    .cure =
        "Look in the logs for what changed then: a feed, a parallel unit, a manual "
        "valve.",
    .split = "record longer on both sides of the change, with u at rest",
    .needs_u = false,
};

class Step final : public Effect {
 public:
  Step() : Effect(kDescription) {}
  [[nodiscard]] SearchedParameters searched(const Situation& s) const override {
    return {{.name = "time",
             .unit = "s",
             .low = 0,
             .high = s.duration_s(),
             .jumpy = true,
             .instant = true,
             .sudden = true},
            {.name = "through_process", .unit = "1", .high = 1, .constant = true},
            {.name = "passing", .unit = "1", .high = 1, .constant = true},
            {.name = "end",
             .unit = "s",
             .low = 0,
             .high = s.duration_s(),
             .jumpy = true,
             .instant = true,
             .sudden = true,
             .only_with = "passing"}};
  }
  [[nodiscard]] std::span<const SolvedParameter> solved() const override {
    static constexpr SolvedParameter kSolved[] = {{"amplitude", "y"}};
    return kSolved;
  }
  [[nodiscard]] OptionalForm optional_form() const override {
    static constexpr std::string_view kPassingOnly[] = {"end"};
    return {"passing", kPassingOnly};
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    const double end = s.duration_s();
    const double lag_s = std::min(s.first_lag_s, end / 5);
    std::vector<Values> out;
    const LevelChanges changes = level_changes(s);
    for (const std::size_t at : changes.for_good) {
      const double time = (static_cast<double>(at) - 0.5) * s.period_s;
      std::size_t first = at;
      std::size_t last = at;
      while (first > 0 && !s.estimation[first - 1]) --first;
      while (last < s.samples() && !s.estimation[last]) ++last;
      // Within a gap of the fitted samples neither the instant nor the way into the
      // output shows: both are looked for once a place there is found to be the best.
      const double gap_s = s.period_s * static_cast<double>(last - first);
      if (first == last) out.push_back({time, 0, 0, end});
      for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        out.push_back(
            {s.period_s * static_cast<double>(first) + share * gap_s, 1, 0, end});
        out.push_back({std::max(0.0, time - 2 * share * lag_s), 1, 0, end});
      }
    }
    for (const PassingLevel& level : changes.passing) {
      const double from = (static_cast<double>(level.first) - 0.5) * s.period_s;
      const double to = (static_cast<double>(level.last) - 0.5) * s.period_s;
      out.push_back({from, 0, 1, to});
      for (const double lags : {0.0, 0.5, 1.0, 2.0}) {
        out.push_back({std::max(0.0, from - lags * lag_s), 1, 1,
                       std::max(from + s.period_s, to - lags * lag_s)});
      }
    }
    return out;
  }
  [[nodiscard]] Excitation excitation(const Situation& s, Reals p) const override {
    if (passes(p)) {
      const double lasts = p[kEnd] - p[kTime];
      const double shorter = std::min(lasts, s.duration_s() - lasts);
      return {static_cast<int>(50 * shorter / s.duration_s()),
              "fiftieths of the recording with the load, or without it"};
    }
    const double shorter = std::min(p[kTime], s.duration_s() - p[kTime]);
    return {static_cast<int>(50 * shorter / s.duration_s()),
            "fiftieths of the recording on the shorter side of the change"};
  }
  [[nodiscard]] std::string evidence(const Situation& s, Reals p,
                                     Reals c) const override {
    if (passes(p)) {
      return filled(
          "From t = {0} until {1} the output is off by {2} y, and u does not cause it.",
          {s.when(p[kTime]), s.when(p[kEnd]), number(c[0], 3)});
    }
    return filled(
        u_jumps_near(s, p[kTime])
            ? "At t = {0} the output shifts by {1} y for good. u jumps then, too: the "
              "process may also answer that move otherwise than the model thinks."
            : "At t = {0} the output shifts by {1} y for good, and u does not cause it.",
        {s.when(p[kTime]), number(c[0], 3)});
  }
  [[nodiscard]] std::string objection(const Situation& s, Reals p,
                                      Reals c) const override {
    if (!s.integrating && std::abs(c[0]) * share_reached(s, p) > s.y_span()) {
      return "it would have to be larger than all that the output does";
    }
    if (is_of_beginning(s, p)) {
      return "it is there at the first sample and gone within three lags: the process "
             "may "
             "have begun otherwise than the model thinks";
    }
    // What comes through the process makes no controller jump.
    const auto jumps = p[kThroughProcess] < 0.5 ? u_jumps_before : u_jumps_near;
    if (!passes(p)) {
      return (has_lone_move(great_jumps_of_u(s)) && jumps(s, p[kTime])) ||
                     answers_lone_move(s, p[kTime])
                 ? "u jumps where it comes: the process may answer otherwise there"
                 : "";
    }
    if (!jumps(s, p[kTime]) || !jumps(s, p[kEnd])) return {};
    return "u jumps where it comes and where it goes: the process may answer otherwise "
           "there";
  }
  [[nodiscard]] double noise_test(const Situation& s, Reals p, Reals c) const override {
    // Chance of the best place over that of one, four standard deviations out in what
    // up to sixty stretches tell: 4²·∫ν/(t(1 − t)) + 4, and of two instants
    // 4⁴/2·∫ν²/(t²(1 − t)), t from 0.02 to 0.98, ν for the gaps between them
    // (James, James & Siegmund 1987; Olshen & Venkatraman 2004).
    constexpr double kPlaces = 50;
    constexpr double kPairs = 640;
    const double places = passes(p) ? kPairs : kPlaces;
    return load_by_chance(s.residual, load_of(*this, s, p, c[0]), places);
  }
  // (W3) At the output at once, or at the input of the process, which answers as to u.
  void load(Reals p, const LoadSetting& setting, Columns columns) const override {
    const std::span<double> column = columns[0];
    const bool at_once = p[kThroughProcess] < 0.5;
    std::vector<double> arriving(column.size());
    const auto change = [&](double time_s, double by) {
      const double samples = (time_s - setting.start_s) / setting.period_s;
      add_change(samples, at_once, by, arriving);
    };
    change(p[kTime], 1);
    if (passes(p)) change(std::max(p[kEnd], p[kTime]), -1);
    if (at_once) {
      std::copy(arriving.begin(), arriving.end(), column.begin());
      return;
    }
    ProcessShape shape;
    shape.first_lag_s = setting.shape.first_lag_s;
    shape.second_lag_s = setting.shape.second_lag_s;
    shape.integrating = setting.shape.integrating;
    std::vector<double> scratch;
    respond(shape, setting.period_s, arriving, scratch, column);
  }
};

}  // namespace

const Effect& disturbance_step() {
  static const Step effect;
  return effect;
}

}  // namespace workbench::effects
