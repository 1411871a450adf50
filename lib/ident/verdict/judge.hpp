// The verdict, from evidence that is free of units.
#pragma once

#include "ident/verdict/identification.hpp"

namespace ident {

/// Turning points of u in five cycles: with fewer, chance has too much of a say.
inline constexpr int kFiveCycles = 10;

/// Closed-loop evidence that needs nothing beside it, nats.
inline constexpr double kAloneNats = 40;

/// Closed-loop evidence below this is none, nats.
inline constexpr double kNoNats = 10;

/// What the evidence amounts to.
struct Judgement {
  Verdict verdict = Verdict::kUndecided;
  Reason reason = Reason::kNone;
};

/// Judges one window. Every threshold is set on simulated loops
/// (host-tests/score/score_verdict.cpp prints what each would do); none has a unit.
/// Where the evidence on the valve does not decide, what the signals and the loop are
/// like says why.
template <class Real>
[[nodiscard]] Judgement judge(const Evidence<Real>& evidence,
                              const LoopEvidence<Real>& loop);

/// Whether a sticking valve is better running free, by enough to be confirmed or not one
/// sample ahead.
template <class Real>
[[nodiscard]] bool better_running_free(const Evidence<Real>& evidence);

/// Judges a window that no valve was fitted to, because the ladder knows of none: does
/// not stick where a band that matters would have shown, else undecided.
template <class Real>
[[nodiscard]] Judgement judge_unfitted(const Evidence<Real>& evidence,
                                       const LoopEvidence<Real>& loop);

/// What the historian's lines between stored points leave of a judgement. Where they are
/// far apart no stem would show between them, so "no stiction" is left open. And a line
/// leads to a point that was stored later: closed-loop evidence, which asks what the past
/// foretells, is no evidence then, and a valve that does not convince running free is
/// left open.
template <class Real>
[[nodiscard]] Judgement doubt_compressed(Judgement found, const Evidence<Real>& evidence,
                                         const RecordHealth<Real>& health);

/// The reason once the intervals of both stick bands are known: a stroke whose interval
/// reaches 0 is not said to stick, and one stroke is said to stick alone only where the
/// other's interval excludes its band. Otherwise kStrokesUnresolved.
template <class Real>
[[nodiscard]] Reason strokes_that_stick(Reason reason, const PerStroke<Real>& band);

}  // namespace ident
