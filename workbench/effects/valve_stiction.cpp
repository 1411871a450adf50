#include <algorithm>

#include "workbench/effects/common.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

constexpr Description kDescription{
    .code = "valve.stiction",
    .title = "stiction",
    .place = Place::kFriction,
    .view = View::kTravel,
    .signature = "is flat for a while after each reversal of u, then jumps",
    .cure =
        "Free the stem: packing too tight, deposits, an undersized actuator. Until "
        "then a smaller integral gain slows the cycle, but does not end it.",
    .split =
        "log the stem position, or stroke the valve slowly by hand through two "
        "reversals",
    .sticks = true,
};

class Stiction final : public Effect {
 public:
  Stiction() : Effect(kDescription) {}
  [[nodiscard]] SearchedParameters searched(const Situation& s) const override {
    const auto width = [&s](std::string_view name, std::optional<double> off) {
      return SearchedParameter{.name = name,
                               .unit = "u",
                               .low = 0,
                               .high = std::max(s.u_span(), 1e-12),
                               .jumpy = true,
                               .off = off,
                               .resolution = stem_resolution(s)};
    };
    return {width("deadband", std::nullopt),
            width("slip_jump_ascending", 0.0),
            width("slip_jump_descending", 0.0),
            {.name = "slide_time",
             .unit = "s",
             .low = s.period_s / 20,
             .high = 10 * s.period_s,
             .logarithmic = true,
             .open_floor = true},
            {.name = "keeps_sliding", .unit = "1", .high = 1, .constant = true},
            searched_stem_start(s, "stuck_stem_start")};
  }
  [[nodiscard]] std::span<const DerivedParameter> derived() const override {
    static constexpr DerivedParameter kDerived[] = {
        {"stick_band_ascending", "u", {"deadband", "slip_jump_ascending"}},
        {"stick_band_descending", "u", {"deadband", "slip_jump_descending"}}};
    return kDerived;
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    // Slips happen at single samples: a start a tenth off the band may miss them all.
    constexpr double kSmallest = 0.02;
    constexpr double kRatio = 1.2;
    // In a cycle that stiction makes, u travels little more than the band.
    constexpr double kWide = 0.5;
    constexpr double kRatioOfWide = 1.1;
    std::vector<Values> out;
    const double quick = s.period_s / 20;
    for (double share = kSmallest; share < 1;
         share *= share < kWide ? kRatio : kRatioOfWide) {
      const double band = share * s.u_span();
      const auto add = [&](double jump_share, double slide, double keeps) {
        const double jump = jump_share * band;
        out.push_back({band - jump, jump, jump, slide, keeps, 0});
      };
      for (const double keeps : {0.0, 1.0}) {
        for (const double jump : {1.0, 0.75, 0.5, 0.25, 0.05}) add(jump, quick, keeps);
        out.push_back({0, band, 0, quick, keeps, 0});
        out.push_back({0, 0, band, quick, keeps, 0});
      }
      for (const double samples : {1.0, 4.0}) {
        for (const double jump : {1.0, 0.6, 0.25}) add(jump, samples * s.period_s, 0);
      }
    }
    for (const SeenStem& stem : s.stems) add_seen(stem, quick, out);
    return out;
  }
  [[nodiscard]] Excitation excitation(const Situation& s, Reals p) const override {
    return reversals_beyond(s, p[0] + std::max(p[1], p[2]),
                            "reversals of u wider than the stick band");
  }
  [[nodiscard]] std::string evidence(const Situation&, Reals p, Reals) const override {
    return filled(
        "After a reversal u travels {0} up or {1} down before the output answers, then "
        "the stem jumps {2} up or {3} down.",
        {number(p[0] + p[1], 3), number(p[0] + p[2], 3), number(p[1], 3),
         number(p[2], 3)});
  }
  // A stem that is never held, but takes its time, is a lag.
  [[nodiscard]] std::string doubt(const Situation& s, Reals p,
                                  Reals lows) const override {
    constexpr double kHeld = 0.01;  // of the span of u
    constexpr double kSlow = 2;     // samples
    const double least = *std::ranges::max_element(lows);
    if (p[3] <= kSlow * s.period_s || least > kHeld * s.u_span()) return {};
    return filled(
        "its stick band may be as narrow as {0}, and a stem that takes {1} s to follow u "
        "is a lag then",
        {number(std::max(least, 0.0), 2), number(p[3], 3)});
  }
  void move(Reals p, ValveSignal& signal) const override {
    move_with_friction({p[0], p[1], p[2], p[3], p[4] > 0.5, p[5]}, signal);
  }

 private:
  // One slip that is missed leads the stem astray for long, so that the error falls only
  // within some parts in a thousand of the band and a few in a hundred of the share that
  // is jump.
  static void add_seen(const SeenStem& stem, double quick, std::vector<Values>& out) {
    constexpr double kStep = 0.005;  // of the band
    constexpr int kSteps = 6;        // to either side
    constexpr double kShare = 0.02;  // of the band, from jump to deadband
    constexpr int kShares = 5;       // to either side
    const double narrow =
        stem.deadband + std::min(stem.slip_ascending, stem.slip_descending);
    const double seen = narrow > 0 ? 1 - stem.deadband / narrow : 1;
    const auto add = [&](double scale, double jump, double keeps) {
      const double up = scale * (stem.deadband + stem.slip_ascending);
      const double down = scale * (stem.deadband + stem.slip_descending);
      const double deadband = (1 - jump) * std::min(up, down);
      out.push_back({deadband, up - deadband, down - deadband, quick, keeps, stem.start});
    };
    for (const double jump : {1.0, 0.75, 0.5, 0.35, 0.2, 0.05}) {
      for (const double scale : {0.94, 0.97, 1.0, 1.03}) {
        for (const double keeps : {0.0, 1.0}) add(scale, jump, keeps);
      }
    }
    add(1, seen, 1);
    for (int traded = -kShares; traded <= kShares; ++traded) {
      for (int step = -kSteps; step <= kSteps; ++step) {
        add(1 + kStep * step, std::clamp(seen + kShare * traded, 0.0, 1.0), 0);
      }
    }
  }
};

}  // namespace

const Effect& valve_stiction() {
  static const Stiction effect;
  return effect;
}

}  // namespace workbench::effects
