// What several effects share: friction, a curve, starts for lags, moves of u.
#pragma once

#include <span>
#include <vector>

#include "workbench/effects/effect.hpp"

namespace workbench::effects {

/// Fouling and ageing need at least as long to show.
inline constexpr double kDay_s = 86400;

/// Where a further lag shows, wherever in the chain it is.
inline constexpr std::string_view kLagSignature =
    "follows past u at small lags, whatever the amplitude";

/// A lag as the only searched parameter, in s: a tenth of a sample period to a fifth of
/// the recording.
[[nodiscard]] SearchedParameters searched_lag(const Situation& situation,
                                              std::string_view name);

/// Ten starts for a lag, from half a sample period to three times the first lag.
[[nodiscard]] std::vector<Values> lag_starts(const Situation& situation);

/// Moves of u by an eighth of its span, either way, for what any move of u shows.
[[nodiscard]] Excitation moves_of_u(const Situation& situation);

/// Reversals of u that a stem with a stick band or gap shows at; of a u that takes two
/// values none does.
[[nodiscard]] Excitation reversals_beyond(const Situation& situation, double band,
                                          std::string_view what);

/// Where u takes two values: that it has none between them, of which an effect would show
/// at least two.
[[nodiscard]] Excitation none_between();

/// (W26) True where u is hardly more than one swing, of two to five such periods.
[[nodiscard]] bool is_overtone_of_u(const Situation& situation, double period_s);

/// Times of the great jumps of u, in s; empty where they are more than ten.
[[nodiscard]] std::vector<double> great_jumps_of_u(const Situation& situation);

/// One or two of them: none tells how the process answers another one.
[[nodiscard]] bool has_lone_move(std::span<const double> great_jumps);

/// (W37) At `time_s` the answer to such a lone move is under way.
[[nodiscard]] bool answers_lone_move(const Situation& situation, double time_s);

/// An effect that any move of u shows.
class ShownByMoves : public Effect {
 public:
  using Effect::Effect;
  [[nodiscard]] Excitation excitation(const Situation& situation,
                                      Reals /*p*/) const override {
    return moves_of_u(situation);
  }
};

/// One more lag: a single searched parameter of that name.
class LagEffect : public ShownByMoves {
 public:
  [[nodiscard]] SearchedParameters searched(const Situation& situation) const override {
    return searched_lag(situation, parameter_);
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& situation) const override {
    return lag_starts(situation);
  }

 protected:
  LagEffect(const Description& description, std::string_view parameter)
      : ShownByMoves(description), parameter_(parameter) {}

 private:
  std::string_view parameter_;
};

/// Friction between signal and stem, in units of u and s, all ≥ 0. The symbols F and J of
/// docs/model.md; all zero is a stem that follows.
struct StemFriction {
  double deadband = 0;        ///< F
  double slip_ascending = 0;  ///< J
  double slip_descending = 0;
  double slide_s = 0;          ///< time constant with which a slipping stem arrives
  bool keeps_sliding = false;  ///< once free it holds again only to turn back (Kano 2004)
  double start = 0;  ///< where the stem rests at first, less v[0]; any sign, moved to
                     ///< where it can rest
};

/// Where the stem rests at first, as a searched parameter; at most so many spans of u
/// from where u is.
[[nodiscard]] SearchedParameter searched_stem_start(const Situation& situation,
                                                    std::string_view name,
                                                    double spans = 1);

/// A level of u, as a parameter that is not searched.
[[nodiscard]] SearchedParameter level_of_u(const Situation& situation,
                                           std::string_view name);

/// How finely a width in u can be told: a stem breaks free between two samples of u. A
/// tenth of the usual move of u in one period, at most a hundredth of its span.
[[nodiscard]] double stem_resolution(const Situation& situation);

/// Drives the signal through the stem; sets `at_rest`. A stem on a
/// spring with a damper and without mass: it holds until the signal is F/2 + J away, then
/// follows at a distance of F/2, and holds again as soon as it has all but arrived.
void move_with_friction(const StemFriction& friction, ValveSignal& signal);

/// Samples over which `residual` remembers: the sum of its autocorrelations up to the
/// first below 0.1. O(n·memory).
[[nodiscard]] double memory_of_noise(std::span<const double> residual);

/// Upper tail of Student's distribution, by a normal score (Wallace 1959).
[[nodiscard]] double student_tail(double t, double degrees);

/// p-value of a load against noise of any colour: a regression of means over stretches
/// that are longer than the residual remembers, so that each speaks for itself. `load` is
/// what was fitted; `places` how many such loads the search could choose from.
[[nodiscard]] double load_by_chance(std::span<const double> residual,
                                    std::span<const double> load, double places);

/// The same for a sinusoid of `period` samples: over stretches of some cycles noise has
/// any phase, a load that swings steadily the same one.
[[nodiscard]] double swing_by_chance(std::span<const double> residual,
                                     std::span<const double> load, double period);

/// What `effect`, a load with one solved parameter `c`, adds to y in the model so far.
[[nodiscard]] std::vector<double> load_of(const Effect& effect,
                                          const Situation& situation, Reals p, double c);

/// Of a Curve: curvature (equal percentage above 0), from, to.
[[nodiscard]] SearchedParameters curve_parameters(const Situation& situation);
[[nodiscard]] std::vector<Values> curve_starts(const Situation& situation);

}  // namespace workbench::effects
