#include "ident/verdict/doubts.hpp"

#include <algorithm>

#include "ident/evidence/stem_search.hpp"

namespace ident {
namespace {

// Squared error of the linear valve over that of the sticking one that needs nothing to
// confirm it one sample ahead.
constexpr Threshold kUnconfirmed = Threshold(1.5);
// Samples from one stored point to the next beyond which nothing firm is said: at the
// ends of lines, and where the last point is held.
constexpr Threshold kFarApart = Threshold(3);
constexpr Threshold kHeldFarApart = Threshold(6);
// Nats of the remembered cycle that are worth a mention, and what a stem must have beside
// them: so many more, and so many times as many.
constexpr Threshold kRemembered = Threshold(20);
constexpr Threshold kNatsAhead = Threshold(20);
constexpr Threshold kTimesAhead = Threshold(1.5);
// Nats of the remembered cycle that is told of any stem, and how many times as many nats
// as the best stem alone one may have beside u then.
constexpr Threshold kClear = Threshold(60);
constexpr Threshold kTimesBeside = Threshold(1.3);
// Nats of a bounded stem over those of the best one that sticks.
constexpr Threshold kTimesBounded = Threshold(1.2);
// What a limit cycle that nothing disturbs has running free: squared error of the linear
// valve over that of the sticking one, and a fit, in percent, that leaves no room for a
// load.
constexpr Threshold kExplainsMost = Threshold(5);
constexpr Threshold kExplainsAll = Threshold(98);
// The same where the cycle repeats with the times of something else, within a tenth.
constexpr Threshold kExplainsNearlyAll = Threshold(88);
// Samples a cycle below which most of what moves is between the samples.
constexpr Threshold kTurnsFast = Threshold(6);

// Whether the cycle is the valve's though it repeats exactly: it leaves nothing that a
// load could have done.
template <class Real>
bool leaves_nothing(const Evidence<Real>& e) {
  return exact(e.error_ratio) >= kExplainsMost && exact(e.fit_percent) > kExplainsAll;
}

// Whether a load of its own time could not have done what the valve does: as good as
// nothing is left of y.
template <class Real>
bool leaves_little(const Evidence<Real>& e) {
  return exact(e.error_ratio) > kExplainsMost &&
         exact(e.fit_percent) > kExplainsNearlyAll;
}

// Something does, but is not enough, or does for something else as well.
bool speaks_for_a_stem(Reason found) {
  return found == Reason::kEvidenceTooWeak || found == Reason::kStemUnconfirmed ||
         found == Reason::kLoadRepeats || found == Reason::kStemBounded;
}

}  // namespace

template <class Real>
Reason doubt_compressed(Reason found, const Evidence<Real>& e,
                        const RecordHealth<Real>& health) {
  if constexpr (!kChecksRecord<Real>) {
    return found;
  }
  const Verdict verdict = verdict_of(found);
  const bool decided = verdict != Verdict::kUndecided;
  if (decided && health.held_apart > Real(kHeldFarApart)) {
    return Reason::kCompressed;
  }
  const bool healthy = verdict == Verdict::kNoStiction;
  const bool far = health.points_apart > Real(kFarApart);
  const bool agreed = e.stem_weighed && exact(e.stem_nats) > Threshold(kAloneNats);
  const bool turns =
      e.reversals >= kEnoughTurns && (!kStemSearch || e.stem_strokes >= kFewestStrokes);
  const bool free_running =
      turns && better_running_free(e) && (agreed || exact(e.error_ratio) > kUnconfirmed);
  const bool foretells = kStemSearch && searched_stem_sticks(e) &&
                         exact(beyond_rivals(e, e.searched.nats)) > Threshold(kAloneNats);
  const bool doubtful = healthy ? far : decided && !free_running && !foretells;
  return health.compressed && doubtful ? Reason::kCompressed : found;
}

template <class Real>
Reason doubt_cut_off(Reason found, const Evidence<Real>& e,
                     const RecordHealth<Real>& health) {
  const bool doubtful =
      speaks_for_a_stem(found) || (is_fault(verdict_of(found)) && !leaves_little(e));
  return kChecksRecord<Real> && health.cut_off > Real(0) && doubtful
             ? Reason::kReadingCutOff
             : found;
}

template <class Real>
bool needs_u(const Evidence<Real>& e) {
  return kStemSearch && exact(e.cycle.nats) > kClear &&
         exact(e.beside_u.nats) > kTimesBeside * exact(best_nats(e));
}

template <class Real>
bool bends(const Evidence<Real>& e) {
  return kStemSearch &&
         exact(e.beside_u.nats) > Threshold(ClosedLoopEvidence<double>::kBends);
}

template <class Real>
bool repeats(const RememberedCycle<Real>& cycle, Real stem_nats) {
  const Threshold clock = exact(cycle.nats);
  return kStemSearch && clock > kRemembered &&
         exact(stem_nats) < std::max(clock + kNatsAhead, kTimesAhead * clock);
}

template <class Real>
bool repeats(const Evidence<Real>& e) {
  return repeats(e.cycle, best_nats(e));
}

template <class Real>
Reason doubt_repeating(Reason found, const Evidence<Real>& e) {
  if (!kStrokePace || !is_fault(verdict_of(found))) {
    return found;
  }
  const bool load = (keeps_foreign_time(e.pace) && !leaves_little(e)) ||
                    (repeats(e) && !leaves_nothing(e)) || needs_u(e);
  return load ? Reason::kLoadRepeats : found;
}

template <class Real>
bool outweighs(Real rival_nats, Real stem_nats) {
  return kStemSearch && exact(rival_nats) > Threshold(kNoNats) &&
         exact(rival_nats) > kTimesBounded * exact(stem_nats);
}

template <class Real>
bool bound_outweighs(const Evidence<Real>& e) {
  return outweighs<Real>(e.bounded.nats, best_nats(e));
}

template <class Real>
Reason doubt_bounded(Reason found, const Evidence<Real>& e) {
  if (!bound_outweighs(e)) {
    return found;
  }
  const bool unsure =
      found == Reason::kEvidenceTooWeak || found == Reason::kStemUnconfirmed ||
      (found == Reason::kLoadRepeats && !repeats(e.cycle, e.bounded.nats));
  return unsure || is_fault(verdict_of(found)) ? Reason::kStemBounded : found;
}

template <class Real>
Reason doubt_bent(Reason found, const Evidence<Real>& e) {
  const bool healthy =
      verdict_of(found) == Verdict::kNoStiction && found != Reason::kBandDoesNotMatter;
  return kStemSearch && healthy && load_may_hide(e) && bends(e) ? Reason::kEvidenceTooWeak
                                                                : found;
}

template <class Real>
Reason doubt_coarse(Reason found, Real period) {
  const bool blind =
      found == Reason::kModelTooPoor || found == Reason::kBandWouldNotShow ||
      found == Reason::kStemUnconfirmed || found == Reason::kEvidenceTooWeak;
  return blind && !kLeastSizes && exact(period) < kTurnsFast ? Reason::kTurnsTooFast
                                                             : found;
}

template <class Real>
bool few_turns(const Evidence<Real>& evidence) {
  constexpr int kFew = 2;
  return kStemSearch && (evidence.reversals <= kFew || evidence.ladder.predicted == 0);
}

template <class Real>
Reason doubt_setpoint(Reason found, const Evidence<Real>& e) {
  const bool left = !e.beside_setpoint.weighed || e.beside_setpoint.nats > Real(0);
  return is_fault(verdict_of(found)) && !left ? Reason::kSetpointMoves : found;
}

template <class Real>
Reason doubt_curved(Reason found, const Evidence<Real>& e) {
  const bool needed = !e.curved.weighed || e.curved.nats > Real(0);
  return is_fault(verdict_of(found)) && !needed ? Reason::kEvidenceTooWeak : found;
}

template <class Real>
Reason explained_by_curve(Reason found, const Evidence<Real>& e,
                          const LoopEvidence<Real>& loop,
                          const RecordHealth<Real>& health) {
  const bool explains = e.curved.weighed && !(e.curved.nats > Real(0)) &&
                        outweighs<Real>(e.curved.curve_nats, best_nats(e));
  if (!may_be_curve(found) || !explains) {
    return found;
  }
  const bool follows = judge_without_stem(e, loop) == Reason::kLinearExplains;
  return follows ? doubt_compressed(Reason::kCurveExplains, e, health) : found;
}

// What speaks one sample ahead for bands that running free are not told from 0. In a few
// turns of u a stem of another band is another one, if any; that is not asked on a bare
// board.
template <class Real>
Real nats_of_bands(const Evidence<Real>& e) {
  const Real stem = nats_of_stems(e, Real(0));
  if constexpr (kStemSearch) {
    const bool rung = e.reversals >= kFiveCycles || has_band(e, e.ladder.band);
    const bool curved = has_band(e, e.curved.wider_band);
    return std::max(
        {stem, rung ? e.ladder.nats : Real(0), curved ? e.curved.nats : Real(0)});
  } else {
    return std::max(stem, e.ladder.nats);
  }
}

template <class Real>
Reason doubt_bands(Reason found, const Evidence<Real>& e, const PerStroke<Real>& fitted) {
  const bool ahead = exact(nats_of_bands(e)) > Threshold(kAgreedNats);
  return is_fault(verdict_of(found)) && reach_zero(fitted) && !ahead
             ? Reason::kEvidenceTooWeak
             : found;
}

template <class Real>
Reason doubt_few_turns(Reason found, const Evidence<Real>& evidence, Real two_path_fit) {
  const bool curves_do_it = few_turns(evidence) && two_path_fit >= evidence.fit_percent;
  const bool lag_does_it = exact(evidence.uneven_ratio) >= 1;
  return is_fault(verdict_of(found)) && (curves_do_it || lag_does_it)
             ? Reason::kTooFewCycles
             : found;
}

template <class Real>
Reason doubted(Reason found, const Evidence<Real>& e, const RecordHealth<Real>& health,
               const PerStroke<Real>& fitted, const WindowFacts<Real>& facts) {
  Reason reason = doubt_repeating(found, e);
  reason = doubt_compressed(reason, e, health);
  reason = doubt_bent(reason, e);
  reason = doubt_coarse(reason, facts.period);
  if constexpr (kStemSearch) {
    reason = doubt_few_turns(reason, e, facts.two_path_fit);
    reason = doubt_bounded(reason, e);
    reason = doubt_setpoint(reason, e);
    reason = doubt_curved(reason, e);
  }
  return doubt_bands(doubt_cut_off(reason, e, health), e, fitted);
}

#define STICKBAND_INSTANTIATE(Real)                                                \
  template Reason doubt_compressed<Real>(Reason, const Evidence<Real>&,            \
                                         const RecordHealth<Real>&);               \
  template Reason doubt_cut_off<Real>(Reason, const Evidence<Real>&,               \
                                      const RecordHealth<Real>&);                  \
  template bool needs_u<Real>(const Evidence<Real>&);                              \
  template bool bends<Real>(const Evidence<Real>&);                                \
  template bool repeats<Real>(const RememberedCycle<Real>&, Real);                 \
  template bool repeats<Real>(const Evidence<Real>&);                              \
  template Reason doubt_repeating<Real>(Reason, const Evidence<Real>&);            \
  template bool outweighs<Real>(Real, Real);                                       \
  template bool bound_outweighs<Real>(const Evidence<Real>&);                      \
  template Reason doubt_bounded<Real>(Reason, const Evidence<Real>&);              \
  template Reason doubt_bent<Real>(Reason, const Evidence<Real>&);                 \
  template Reason doubt_setpoint<Real>(Reason, const Evidence<Real>&);             \
  template Reason doubt_curved<Real>(Reason, const Evidence<Real>&);               \
  template Reason explained_by_curve<Real>(Reason, const Evidence<Real>&,          \
                                           const LoopEvidence<Real>&,              \
                                           const RecordHealth<Real>&);             \
  template bool few_turns<Real>(const Evidence<Real>&);                            \
  template Reason doubt_few_turns<Real>(Reason, const Evidence<Real>&, Real);      \
  template Reason doubt_bands<Real>(Reason, const Evidence<Real>&,                 \
                                    const PerStroke<Real>&);                       \
  template Reason doubted<Real>(Reason, const Evidence<Real>&,                     \
                                const RecordHealth<Real>&, const PerStroke<Real>&, \
                                const WindowFacts<Real>&);                         \
  template Reason doubt_coarse<Real>(Reason, Real);
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)

}  // namespace ident
