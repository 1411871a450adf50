#include "ident/verdict/judge.hpp"

#include <algorithm>

#include "ident/evidence/stem_search.hpp"

namespace ident {
namespace {

// A valve that explains less than this share of y, in percent, is not what moves y.
constexpr Threshold kPoorFit = Threshold(25);
// Nor, below this one, is a stem the valve's that foretells y one sample ahead alone: so
// does what knows where a load stands that comes and goes in steps.
constexpr Threshold kLeastFit = Threshold(15);
// Unless it has kAloneNats beyond what does its work, or its band is wider than this
// share of the swing of u: such a stem knows of no level between the extremes, and where
// the load drifts as far as u swings no valve explains y running free.
constexpr Threshold kKnowsNoLevel = Threshold(0.5);
// But a stem that leaves all but this share of y, in percent, to loads moves nothing.
constexpr Threshold kMovesNothing = Threshold(6);
// Log-likelihood gain over the linear valve, in nats: enough to claim, worth a mention.
constexpr Threshold kEnough = Threshold(10);
constexpr Threshold kSuggestive = Threshold(3);
// Squared error of the linear valve over that of the sticking one: beyond doubt, and
// enough where the gain is steady.
constexpr Threshold kOverwhelming = Threshold(2.5);
constexpr Threshold kLarge = Threshold(1.75);
// Below this the sticking valve is no better in practice.
constexpr Threshold kNegligible = Threshold(1.1);
// Stick band over the usual swing of u: the least that matters.
constexpr Threshold kLeastBand = Threshold(0.05);
// The gain must come from nearly every cycle, not from a lucky few.
constexpr Threshold kConsistent = Threshold(2.3);
// A slip jump below this share of the stick band is play, not stiction.
constexpr Threshold kLeastSlip = Threshold(0.08);
// A time constant below this share of the period is self-regulating; a loop whose band
// takes more than this share of the swing of u hunts across it.
constexpr Threshold kSelfRegulating = Threshold(0.5);
constexpr Threshold kHuntsAcross = Threshold(0.45);
// Stick band over the resolution of u: rounding is a stem by itself, half a step to
// either side.
constexpr Threshold kFewestSteps = Threshold(2);
// Resolution over the usual swing: too coarse to say that nothing sticks, and coarse
// enough to be why the data cannot tell.
constexpr Threshold kHopeless = Threshold(0.5);
constexpr Threshold kCoarse = Threshold(0.2);
// Share of the time at a limit beyond which only a linear valve can be told.
constexpr Threshold kAtLimit = Threshold(0.25);
// The same of a step test by hand, whose highest and lowest levels are no limits.
constexpr Threshold kMostlyAtEnds = Threshold(0.8);
// Closed-loop evidence, nats, beside kAloneNats and kAgreedNats: that a stem which
// convinces running free is confirmed one sample ahead.
constexpr Threshold kConfirmed = Threshold(10);
// The same where u turns a few times only: each turn is a trial of its own, and what
// chance brings grows with the number of samples that are predicted between them.
constexpr Threshold kFewTurns = Threshold(8);
// Closed-loop evidence beyond that of what else would do the stem's work, where that was
// weighed, nats: what needs nothing beside it.
constexpr Threshold kBeyondRivals = Threshold(20);
// Running free, to agree: squared error of the linear valve over that of the sticking
// one.
constexpr Threshold kBetter = Threshold(1.15);
constexpr Threshold kMoreCycles = Threshold(0.66);
// A valve that follows u explains this share of y, in percent: no load hides a stem.
constexpr Threshold kWellExplained = Threshold(80);
// The same where a valve fitted to a few turns, under loads, is compared.
constexpr Threshold kMuchTheSame = Threshold(2);
// A stem whose band is narrower than this share of the swing leaves out the noise that
// the controller passes on to u, and with it foretells a load that comes in steps: it is
// believed where a valve that was fitted running free has the same band.
constexpr Threshold kLeavesNoiseOut = Threshold(0.35);
// A band that would show only above this share of the usual swing may hide one that
// matters.
constexpr Threshold kHidden = Threshold(0.35);
constexpr std::size_t kEnoughToHope = 300;  // predicted samples
// What a stem does at one turn of u a load that drifts, or a curve, does as well.
constexpr int kFewestTurns = 2;
// Unless the stem turned back so often, in turns of u too small to count.
constexpr int kFewestStems = 4;
// Turning points of u without which nothing is said about a valve.
constexpr int kFewestReversals = kSmallSizes ? kFewestTurns : 1;

// Better running free, not beyond doubt, and not in a lucky stretch only.
template <class Real>
bool steadily_better(const Evidence<Real>& e) {
  return exact(e.score) > kEnough && exact(e.error_ratio) > kBetter &&
         exact(e.consistency) > kConsistent;
}

// Whether a band that foretells y may be the valve's: wide enough to leave no noise out.
template <class Real>
bool may_have(const Evidence<Real>& e, Real band) {
  return exact(band) < kWidestBand &&
         (exact(band) > kLeavesNoiseOut || has_band(e, band));
}

// Closed-loop evidence for the valve that was fitted running free.
template <class Real>
Threshold confirmation(const Evidence<Real>& e) {
  const Threshold stem = e.stem_weighed ? exact(e.stem_nats) : 0;
  return has_band(e, e.ladder.band) ? std::max(stem, exact(e.ladder.nats)) : stem;
}

// Whether so many nats of a stem need nothing beside them.
template <class Real>
bool speaks_alone(const Evidence<Real>& e, Real nats) {
  const bool weighed = kStemSearch && e.ladder.nats > Real(0);
  return exact(beyond_rivals(e, nats)) >
         (weighed ? kBeyondRivals : Threshold(kAloneNats));
}

// The same of the stem that was fitted running free.
template <class Real>
bool fitted_speaks_alone(const Evidence<Real>& e) {
  return e.stem_weighed && speaks_alone(e, e.stem_nats);
}

// Whether the valve that was found explains enough of y, running free, for a stem that
// only foretells y to be its own, or the stem has nats enough to need none of that. The
// small sizes, for lack of flash, leave that open.
template <class Real>
bool moves_output(const Evidence<Real>& e) {
  const bool wide = kStemSearch && exact(e.fit_percent) > kMovesNothing &&
                    exact(e.searched.wider_band()) > kKnowsNoLevel;
  const bool sure =
      kStemSearch && exact(beyond_rivals(e, best_nats(e))) > Threshold(kAloneNats);
  return kSmallSizes || exact(e.fit_percent) > kLeastFit || wide || sure;
}

template <class Real>
bool convinces(const Evidence<Real>& e) {
  if (exact(e.score) < kEnough) {
    return false;
  }
  // In a few turns of u a curved process gains as much, but not steadily. Nor does it
  // foretell y.
  if (exact(e.error_ratio) > kOverwhelming &&
      (e.reversals >= kFiveCycles || fitted_speaks_alone(e))) {
    return exact(e.consistency) > 0;
  }
  return steadily_better(e) && exact(e.error_ratio) > kLarge;
}

// Whether the window was long enough for any.
template <class Real>
bool is_weighed(const Evidence<Real>& e) {
  return e.ladder.predicted > 0;
}

template <class Real>
bool better_in_most_cycles(const Evidence<Real>& e) {
  return steadily_better(e) && exact(e.cycles_better) >= kMoreCycles * exact(e.cycles) &&
         e.reversals >= kEnoughTurns;
}

// Better running free and one sample ahead, in a few turns of u.
template <class Real>
bool better_in_few_turns(const Evidence<Real>& e) {
  const bool few = e.reversals >= kFewestTurns && e.reversals < kFiveCycles;
  return few && steadily_better(e) && confirmation(e) > kFewTurns;
}

// Better running free, and one sample ahead where a bent characteristic and the setpoint
// are known, by much the same band.
template <class Real>
bool better_beside_curve(const Evidence<Real>& e) {
  const Threshold band = exact(e.band_over_swing);
  return kStemSearch && e.reversals < kFiveCycles && exact(e.score) > kEnough &&
         exact(e.error_ratio) > kLarge && exact(e.consistency) > 0 &&
         exact(e.curved.nats) > Threshold(kNoNats) &&
         exact(e.curved.narrower_band) * kMuchTheSame > band &&
         exact(e.curved.wider_band) < band * kMuchTheSame;
}

// Whether a rung of the ladder alone says so, where no fitted valve does and none of
// others was asked.
template <class Real>
bool ladder_sticks(const Evidence<Real>& e) {
  return exact(e.ladder.nats) > Threshold(kAloneNats) &&
         e.ladder.strokes >= kFewestStrokes &&
         (kSmallSizes || e.reversals >= kFiveCycles) &&
         exact(e.ladder.band) > kLeastBand && exact(e.ladder.band) < kWidestBand;
}

// Whether, of a linear valve, nothing speaks for another one though it would have shown.
template <class Real>
bool nothing_would_hide(const Evidence<Real>& e) {
  const Threshold shown = exact(e.ladder.detectable_band);
  return kStemSearch && is_weighed(e) && e.form == ValveForm::kLinear && shown > 0 &&
         shown <= kHidden && exact(best_nats(e)) <= 0;
}

// What no evidence for sticking means.
template <class Real>
Reason nothing_found(const Evidence<Real>& e, bool oscillates, bool poor) {
  if (!is_weighed(e) && poor) {
    return oscillates ? Reason::kNotTheValve : Reason::kModelTooPoor;
  }
  if (!is_weighed(e)) {
    return load_may_hide(e) ? Reason::kBandWouldNotShow : Reason::kLinearExplains;
  }
  // What moves u by hand, y cannot have caused: then a few turns tell what they show.
  const bool few = e.reversals < kFiveCycles;
  if (few && !(kStemSearch && e.by_hand && e.reversals > 1)) {
    return Reason::kTooFewCycles;
  }
  if (!few && nothing_would_hide(e)) {
    return poor && oscillates ? Reason::kNotTheValve : Reason::kLinearExplains;
  }
  if (poor && !oscillates) {
    return Reason::kModelTooPoor;
  }
  // Nor is a swing on a drift one that u comes back to; and under a load few samples
  // hold no more than hope.
  const bool long_enough = !load_may_hide(e) || e.ladder.predicted >= kEnoughToHope;
  const bool steady = kStemSearch && !few && !e.drifts && long_enough;
  const Threshold hoped = exact(shown_or_excluded(e, steady));
  if (!(hoped > 0) || hoped > kHidden) {
    return Reason::kBandWouldNotShow;
  }
  return poor ? Reason::kNotTheValve : Reason::kLinearExplains;
}

template <class Real>
Reason judge_valve(const Evidence<Real>& e, bool oscillates) {
  if (e.reversals < kFewestReversals) {
    return Reason::kOneStroke;
  }
  const bool fitted = fitted_valve_sticks(e);
  const bool seen_ahead = load_may_hide(e) && moves_output(e) &&
                          (e.searched.asked ? searched_stem_sticks(e) : ladder_sticks(e));
  if (!fitted && seen_ahead) {
    return Reason::kSticksUnderLoad;
  }
  if (!fitted) {
    const bool suspect = e.form != ValveForm::kLinear && exact(e.score) >= kSuggestive &&
                         exact(e.error_ratio) >= kNegligible &&
                         exact(e.fit_percent) >= kPoorFit;
    const bool confirmed = is_weighed(e) && exact(best_nats(e)) > Threshold(kNoNats);
    if (suspect && exact(e.band_over_swing) < kLeastBand) {
      return Reason::kBandDoesNotMatter;
    }
    if (is_weighed(e) && convinces(e) && !confirmed) {
      return Reason::kStemUnconfirmed;
    }
    if (confirmed || (suspect && (!is_weighed(e) || better_in_most_cycles(e)))) {
      return Reason::kEvidenceTooWeak;
    }
    return nothing_found(e, oscillates, exact(e.fit_percent) < kPoorFit);
  }
  if (exact(e.band_over_swing) < kLeastBand) {
    return Reason::kBandDoesNotMatter;
  }
  if (exact(e.slip_over_band) < kLeastSlip) {
    // Play alone cannot keep a self-regulating loop with integral action oscillating.
    const bool cannot_be_play = oscillates && exact(e.time_constant) < kSelfRegulating &&
                                exact(e.band_over_swing) > kHuntsAcross;
    return cannot_be_play ? Reason::kSlipUnresolved : Reason::kDeadbandOnly;
  }
  switch (e.form) {
    case ValveForm::kAscending:
      return Reason::kSticksAscending;
    case ValveForm::kDescending:
      return Reason::kSticksDescending;
    default:
      return Reason::kSticksBothStrokes;
  }
}

// What the record itself allows to be said.
template <class Real>
Reason qualified(Reason found, const Evidence<Real>& e, const LoopEvidence<Real>& loop) {
  if (found == Reason::kOneStroke) {
    return found;
  }
  const Verdict verdict = verdict_of(found);
  const bool fault = is_fault(verdict);
  const bool healthy = verdict == Verdict::kNoStiction;
  const Real band = found != Reason::kSticksUnderLoad ? e.band_over_swing
                    : searched_stem_sticks(e)         ? e.searched.wider_band()
                                                      : e.ladder.band;
  const Threshold step = exact(fault ? Real(kFewestSteps) * loop.u_step / band
                                     : std::max(loop.u_step, loop.y_step));
  if ((fault && few_levels(loop)) ||
      step > (fault ? 1 : (healthy ? kHopeless : kCoarse))) {
    return Reason::kBandBelowResolution;
  }
  // Between limits u is as flat as a stem that sticks.
  const bool linear = healthy && found != Reason::kNotTheValve &&
                      (!kStemSearch || e.ladder.detectable_band > Real(0));
  // A coarse u rests for a while at its extremes anyway, and in a step test by hand at
  // all of its levels.
  const Real rest = loop.limit_share - Real(2) * loop.u_step;
  const bool among_levels = e.by_hand && exact(loop.limit_share) < kMostlyAtEnds;
  if (exact(rest) > kAtLimit && !linear && !among_levels) {
    return Reason::kAtLimit;
  }
  if (verdict != Verdict::kUndecided) {
    return found;
  }
  const bool speaks = found == Reason::kEvidenceTooWeak && is_weighed(e) &&
                      exact(best_nats(e)) > Threshold(kAgreedNats);
  if (setpoint_moves(loop) && !speaks) {
    return nothing_would_hide(e) ? Reason::kLinearExplains : Reason::kSetpointMoves;
  }
  const bool few =
      (found == Reason::kEvidenceTooWeak || found == Reason::kStemUnconfirmed) &&
      e.reversals < kFiveCycles;
  return few ? Reason::kTooFewCycles : found;
}

}  // namespace

template <class Real>
Real beyond_rivals(const Evidence<Real>& e, Real nats) {
  return nats - std::max(e.cycle.nats, Real(0)) - std::max(e.bounded.nats, Real(0));
}

template <class Real>
bool fitted_valve_sticks(const Evidence<Real>& e) {
  const bool seen_ahead = fitted_speaks_alone(e) && e.stem_strokes >= kFewestStrokes;
  const bool wide = exact(e.band_over_swing) >= kWidestBand;
  const bool turns = e.reversals >= kFewestTurns || e.stem_strokes >= kFewestStems;
  const bool doubtful = kSmallSizes ? wide : !turns;
  if (e.form == ValveForm::kLinear || doubtful) {
    return false;
  }
  if (!is_weighed(e)) {
    return convinces(e) && !wide;
  }
  const Threshold nats = confirmation(e);
  const bool alone = seen_ahead && moves_output(e) &&
                     (load_may_hide(e) || exact(e.error_ratio) > kBetter);
  return (convinces(e) && nats > kConfirmed) ||
         (better_in_most_cycles(e) && nats > Threshold(kAgreedNats)) ||
         better_in_few_turns(e) || better_beside_curve(e) || alone;
}

template <class Real>
bool load_may_hide(const Evidence<Real>& e) {
  return exact(e.fit_linear_percent) < kWellExplained;
}

template <class Real>
bool searched_stem_sticks(const Evidence<Real>& e) {
  const SearchedStem<Real>& stem = e.searched;
  const Real band = stem.wider_band();
  return stem.asked && speaks_alone(e, stem.nats) && stem.strokes >= kFewestStrokes &&
         e.reversals >= kFiveCycles && exact(band) > kLeastBand && may_have(e, band);
}

template <class Real>
bool may_stick_together(const Evidence<Real>& e) {
  return moves_output(e) && (!kStemSearch || may_have(e, e.ladder.band));
}

template <class Real>
Reason judge(const Evidence<Real>& e, const LoopEvidence<Real>& loop) {
  return qualified(judge_valve(e, loop.oscillates), e, loop);
}

template <class Real>
bool searched_stem_is_told(const Evidence<Real>& e, const PerStroke<Real>& fitted) {
  const Real stem_nats = e.stem_weighed ? e.stem_nats : Real(0);
  return searched_stem_sticks(e) &&
         (reach_zero(fitted) ||
          exact(e.searched.nats) > Threshold(kNearNats) + exact(stem_nats));
}

template <class Real>
bool better_running_free(const Evidence<Real>& e) {
  return e.form != ValveForm::kLinear && (convinces(e) || better_in_most_cycles(e));
}

template <class Real>
Reason judge_without_stem(const Evidence<Real>& e, const LoopEvidence<Real>& loop) {
  // Where nothing was fitted, only an oscillation shows that u moves y.
  const bool fitted = e.fit_linear_percent > Real(0);
  const bool poor = fitted ? exact(e.fit_linear_percent) < kPoorFit : !loop.oscillates;
  return qualified(nothing_found(e, loop.oscillates, poor), e, loop);
}

#define STICKBAND_INSTANTIATE(Real)                                    \
  template Real beyond_rivals<Real>(const Evidence<Real>&, Real);      \
  template bool fitted_valve_sticks<Real>(const Evidence<Real>&);      \
  template bool load_may_hide<Real>(const Evidence<Real>&);            \
  template bool may_stick_together<Real>(const Evidence<Real>&);       \
  template bool searched_stem_sticks<Real>(const Evidence<Real>&);     \
  template bool searched_stem_is_told<Real>(const Evidence<Real>&,     \
                                            const PerStroke<Real>&);   \
  template bool better_running_free<Real>(const Evidence<Real>&);      \
  template Reason judge_without_stem<Real>(const Evidence<Real>&,      \
                                           const LoopEvidence<Real>&); \
  template Reason judge<Real>(const Evidence<Real>&, const LoopEvidence<Real>&);
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)

}  // namespace ident
