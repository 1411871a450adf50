// The verdict, from evidence that is free of units.
#pragma once

#include "ident/verdict/identification.hpp"

namespace ident {

/// Turning points of u in five cycles: with fewer, chance has too much of a say.
inline constexpr int kFiveCycles = 10;
/// In ten: with fewer, a setpoint that moves may do what a stem does.
inline constexpr int kTenCycles = 20;
/// Turning points of u below which most cycles may be better by chance.
inline constexpr int kEnoughTurns = 6;

/// Closed-loop evidence that needs nothing beside it where its rivals were not weighed,
/// nats: 40, and 6 more because a stem that speaks is the best of some four hundred.
inline constexpr double kAloneNats = 46;

/// Closed-loop evidence that confirms what is better running free in most cycles, not
/// beyond doubt, nats.
inline constexpr double kAgreedNats = 25;

/// Closed-loop evidence below this is none, nats.
inline constexpr double kNoNats = 10;

/// Judges one window. Every threshold is set on simulated loops
/// (host-tests/score/score_verdict.cpp prints what each would do); none has a unit.
/// Where the evidence on the valve does not decide, what the signals and the loop are
/// like says why.
template <class Real>
[[nodiscard]] Reason judge(const Evidence<Real>& evidence,
                           const LoopEvidence<Real>& loop);

/// Whether the fitted valve sticks or has play: beyond doubt running free and confirmed
/// one sample ahead, or in both ways, or beyond doubt one sample ahead.
template <class Real>
[[nodiscard]] bool fitted_valve_sticks(const Evidence<Real>& evidence);

/// Whether a load may hide from the free run what a stem says one sample ahead: not where
/// a valve that follows u explains y well.
template <class Real>
[[nodiscard]] bool load_may_hide(const Evidence<Real>& evidence);

/// Stick band over the swing. A stem whose band is wider than the usual swing moves by
/// chance when something happens; it is believed where a fitted valve confirms it running
/// free, which the small sizes do not ask.
inline constexpr Threshold kWidestBand = Threshold(1.05);

/// Whether the valve that was fitted running free has that band, over the swing.
template <class Real>
[[nodiscard]] bool has_band(const Evidence<Real>& evidence, Real band) {
  // The same band, seen in two ways, within this factor.
  constexpr Threshold kSameBand = Threshold(1.5);
  const Threshold ratio = exact(band / evidence.band_over_swing);
  return ratio > 1 / kSameBand && ratio < kSameBand;
}

/// Whether the valve of this window may be one of which only several windows together
/// leave no doubt: it moves the output, u swings beyond its band, and that is wide enough
/// to leave no noise out, or that of the valve fitted running free. Without a search of
/// stems the band is not asked.
template <class Real>
[[nodiscard]] bool may_stick_together(const Evidence<Real>& evidence);

/// Whether y takes so few levels that the controller hunts between them whatever the
/// valve does. Not in the small sizes.
template <class Real>
[[nodiscard]] bool few_levels(const LoopEvidence<Real>& loop) {
  constexpr Threshold kFewLevels = Threshold(0.3);
  return kStemSearch && exact(loop.y_step) > kFewLevels;
}

/// What of the nats of a stem is beyond what does a stem's work and does not stick: the
/// cycle before (E15) and bounded stems (E19).
template <class Real>
[[nodiscard]] Real beyond_rivals(const Evidence<Real>& evidence, Real nats);

/// Whether a stem that was searched one sample ahead says that the valve sticks.
template <class Real>
[[nodiscard]] bool searched_stem_sticks(const Evidence<Real>& evidence);

/// Whether the intervals of both stick bands reach 0.
template <class Real>
[[nodiscard]] bool reach_zero(const PerStroke<Real>& band) {
  return !(band.ascending.low > Real(0)) && !(band.descending.low > Real(0));
}

/// Whether the bands of such a stem are to be told instead of `fitted`: it foretells y so
/// much better than the fitted one, because a load has led the free run to another valve,
/// or the free run does not tell the fitted bands from 0.
template <class Real>
[[nodiscard]] bool searched_stem_is_told(const Evidence<Real>& evidence,
                                         const PerStroke<Real>& fitted);

/// Whether a sticking valve is better running free, by enough to be confirmed or not one
/// sample ahead.
template <class Real>
[[nodiscard]] bool better_running_free(const Evidence<Real>& evidence);

/// Judges a window as if no stem spoke, because the ladder knows of none and no valve was
/// fitted, or because what spoke is none: does not stick where a band that matters would
/// have shown, else undecided.
template <class Real>
[[nodiscard]] Reason judge_without_stem(const Evidence<Real>& evidence,
                                        const LoopEvidence<Real>& loop);

/// The reason once the intervals of both stick bands are known: a stroke whose interval
/// reaches 0 is not said to stick, and one stroke is said to stick alone only where the
/// other's interval lies below its own. Otherwise kStrokesUnresolved.
template <class Real>
[[nodiscard]] Reason strokes_that_stick(Reason reason, const PerStroke<Real>& band);

}  // namespace ident
