// What makes a judgement doubtful: the historian, a load that keeps a clock, a valve that
// is slow or stops, and samples that are too far apart.
#pragma once

#include "ident/signal/record_check.hpp"
#include "ident/verdict/evidence.hpp"
#include "ident/verdict/judge.hpp"

namespace ident {

/// What the historian leaves of a judgement. Where it held y from one stored point to a
/// far one, nothing. Where lines are between points that are far apart no stem would show
/// between them, so "no stiction" is left open. And a line leads to a point that was
/// stored later: closed-loop evidence, which asks what the past foretells, is none by
/// itself then: a valve that is not better running free, too, by much or beside much of
/// it, and in more than a few turns, is left open, but for a stem that outdoes its rivals
/// by as much as one on its own has to have.
template <class Real>
[[nodiscard]] Reason doubt_compressed(Reason found, const Evidence<Real>& evidence,
                                      const RecordHealth<Real>& health);

/// What a reading that is cut off (E26) leaves of a judgement. y rests there as behind a
/// stem that does not move: no fault, unless the valve leaves as good as nothing of y,
/// and nothing that only speaks for one.
template <class Real>
[[nodiscard]] Reason doubt_cut_off(Reason found, const Evidence<Real>& evidence,
                                   const RecordHealth<Real>& health);

/// Whether the best stem needs u beside it where y clearly keeps a clock (E15, E17): it
/// remembers where a load stands that switches, and the valve follows.
template <class Real>
[[nodiscard]] bool needs_u(const Evidence<Real>& evidence);
/// Whether a stem tells so much beside u that y does not follow from u as the band
/// that is hoped for supposes (E12, E17).
template <class Real>
[[nodiscard]] bool bends(const Evidence<Real>& evidence);
/// Whether the lags of one cycle ago foretell y nearly as well as a stem of so many nats.
template <class Real>
[[nodiscard]] bool repeats(const RememberedCycle<Real>& cycle, Real stem_nats);
/// The same of a bounded stem beside the best one of all that were asked.
template <class Real>
[[nodiscard]] bool repeats(const Evidence<Real>& evidence);

/// What a load that comes back at its own time leaves of a fault (E15, E18): where the
/// strokes of u keep a foreign time (stroke_pace.hpp) it is left open, unless the valve
/// explains nearly all of y; where the lags of one cycle ago foretell y nearly as well as
/// any stem does, it is left open, unless the valve leaves next to nothing of y: a limit
/// cycle that nothing disturbs repeats exactly, too. So it is where the best stem needs
/// u.
template <class Real>
[[nodiscard]] Reason doubt_repeating(Reason found, const Evidence<Real>& evidence);

/// Whether what does not stick, a bounded stem (E19) or a curve (E24), has clearly more
/// nats, `rival_nats`, than a stem that sticks has.
template <class Real>
[[nodiscard]] bool outweighs(Real rival_nats, Real stem_nats);
/// The same beside the best stem of all that were asked.
template <class Real>
[[nodiscard]] bool bound_outweighs(const Evidence<Real>& evidence);
/// What bound_outweighs() leaves of a fault: nothing firm. And of what was left open
/// because a fault was not sure: a name, unless what happened one cycle ago tells nearly
/// as much.
template <class Real>
[[nodiscard]] Reason doubt_bounded(Reason found, const Evidence<Real>& evidence);

/// What a stem that tells much beside u (E17) leaves of "no stiction" where a load may
/// hide the valve: nothing firm.
template <class Real>
[[nodiscard]] Reason doubt_bent(Reason found, const Evidence<Real>& evidence);

/// What a fault is where the setpoint moves and its lags leave the stem nothing to tell
/// (E20): left open. u remembers y between the samples, and a setpoint that is not known
/// hides that.
template <class Real>
[[nodiscard]] Reason doubt_setpoint(Reason found, const Evidence<Real>& evidence);

/// What a fault in a few turns of u is where a bent characteristic and the setpoint leave
/// the stem nothing to tell (E23): left open.
template <class Real>
[[nodiscard]] Reason doubt_curved(Reason found, const Evidence<Real>& evidence);

/// Whether a reason leaves a window open for what a stem tells, which a bent
/// characteristic may tell as well.
[[nodiscard]] constexpr bool may_be_curve(Reason found) {
  return found == Reason::kEvidenceTooWeak || found == Reason::kStemUnconfirmed ||
         found == Reason::kStemBounded;
}
/// What such a characteristic (E24) makes of it where it tells clearly more than any stem
/// and leaves none anything to tell (E23): no stiction, if the window were judged so
/// without a stem.
template <class Real>
[[nodiscard]] Reason explained_by_curve(Reason found, const Evidence<Real>& evidence,
                                        const LoopEvidence<Real>& loop,
                                        const RecordHealth<Real>& health);

/// What intervals of both stick bands that reach 0 leave of a fault, `fitted` running
/// free: nothing firm, unless a stem says more than a little one sample ahead.
template <class Real>
[[nodiscard]] Reason doubt_bands(Reason found, const Evidence<Real>& evidence,
                                 const PerStroke<Real>& fitted);

/// Whether u turns twice at most, or the window is too short to predict in (E10): then no
/// fault is told before the two-path model was asked. Not where no stem is searched
/// (kStemSearch), for lack of flash.
template <class Real>
[[nodiscard]] bool few_turns(const Evidence<Real>& evidence);
/// What few_turns() leaves of a fault that two curves of u (the two-path model) explain
/// as well: there a curved process, or a load that comes three times, does what a stem
/// does. Nor is one told that a lag which depends on direction explains as well (E22).
/// `two_path_fit`: of the two-path model, percent.
template <class Real>
[[nodiscard]] Reason doubt_few_turns(Reason found, const Evidence<Real>& evidence,
                                     Real two_path_fit);

/// Why a window is left open in which u turns within three samples, however good the
/// valve: what moves between the samples is not in the record. `period`: of u, samples.
template <class Real>
[[nodiscard]] Reason doubt_coarse(Reason found, Real period);

/// What else the doubts ask of a window.
template <class Real>
struct WindowFacts {
  Real period = 0;        ///< of u, samples
  Real two_path_fit = 0;  ///< of the two-path model, percent
};

/// What all of them leave of a judgement, one after the other.
template <class Real>
[[nodiscard]] Reason doubted(Reason found, const Evidence<Real>& evidence,
                             const RecordHealth<Real>& health,
                             const PerStroke<Real>& fitted,
                             const WindowFacts<Real>& facts);

}  // namespace ident
