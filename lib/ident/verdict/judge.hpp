// The verdict, from evidence that is free of units.
#pragma once

#include "ident/verdict/identification.hpp"

namespace ident {

/// Turning points of u in five cycles: with fewer, chance has too much of a say.
inline constexpr int kFiveCycles = 10;

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

/// "No stiction" is left open where the historian stored points too far apart for a stem
/// to show between them.
template <class Real>
[[nodiscard]] Judgement doubt_compressed(Judgement found,
                                         const RecordHealth<Real>& health);

/// The reason once the intervals of both stick bands are known: a stroke whose interval
/// reaches 0 is not said to stick beside one whose does not.
[[nodiscard]] Reason strokes_that_stick(Reason reason, bool ascending_surely,
                                        bool descending_surely);

}  // namespace ident
