// The verdict, from evidence that is free of units.
#pragma once

#include "ident/identification.hpp"

namespace ident {

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

}  // namespace ident
