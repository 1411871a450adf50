// Whether u keeps the time of something else.
#pragma once

#include <span>

#include "ident/base/limits.hpp"
#include "ident/signal/reversals.hpp"

namespace ident {

/// How the strokes of a window differ among those of their own direction. Nothing with
/// the small sizes (kStrokePace).
template <class Real, bool kKept = kStrokePace>
struct StrokePace {
  int strokes = 0;    ///< that were compared
  Real spread = 0;    ///< standard deviation of their durations over the mean
  Real together = 0;  ///< correlation of duration and distance, −1 … 1
};
template <class Real>
struct StrokePace<Real, false> {};

/// `strokes`: the way of each to the next turning point, value its distance and index its
/// samples, one up and one down in turns. Cost: two passes.
template <class Real>
[[nodiscard]] StrokePace<Real, true> measure_pace(
    std::span<const Reversal<Real>> strokes);

/// (E18) Whether the strokes last nearly equally long, and longer ones go farther: u
/// follows what comes back at its own time. In a loop whose valve sticks a stroke ends
/// where the stem slips: it lasts longer where u goes more slowly, and goes less beyond.
template <class Real>
[[nodiscard]] bool keeps_foreign_time(const StrokePace<Real>& pace);

}  // namespace ident
