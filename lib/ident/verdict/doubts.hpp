// What makes a judgement doubtful: the historian, a load that keeps a clock, and samples
// that are too far apart.
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
/// it, is left open.
template <class Real>
[[nodiscard]] Judgement doubt_compressed(Judgement found, const Evidence<Real>& evidence,
                                         const RecordHealth<Real>& health);

/// Whether the lags of one cycle ago foretell y nearly as well as a stem of so many nats.
template <class Real>
[[nodiscard]] bool repeats(const RememberedCycle<Real>& cycle, Real stem_nats);
/// The same beside the best stem of all that were asked.
template <class Real>
[[nodiscard]] bool repeats(const Evidence<Real>& evidence);

/// What a load that keeps a clock leaves of a fault (E15): where the lags of one cycle
/// ago foretell y nearly as well as any stem does, and no valve explains y far better
/// running free, it is left open. A limit cycle without any load repeats exactly, too,
/// but then the valve explains all of it.
template <class Real>
[[nodiscard]] Judgement doubt_repeating(Judgement found, const Evidence<Real>& evidence);

/// Why a window is left open in which u turns within three samples, however good the
/// valve: what moves between the samples is not in the record. `period`: of u, samples.
template <class Real>
[[nodiscard]] Judgement doubt_coarse(Judgement found, Real period);

}  // namespace ident
