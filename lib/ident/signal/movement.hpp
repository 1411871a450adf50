// How u moves in a window: turning points, swing, period.
#pragma once

#include <cstddef>
#include <span>

#include "ident/signal/oscillation_detector.hpp"
#include "ident/signal/stroke_pace.hpp"

namespace ident {

/// Share of the range of u that it retreats by from a turning point.
inline constexpr double kReversalShare = 0.3;

/// What the searches need to know about u.
template <class Real>
struct Movement {
  int reversals = 0;  ///< turning points
  Real swing = 1;     ///< median distance between neighbouring ones, units of u
  Real period = 0;    ///< samples per cycle, 4 … two thirds of the window
  Real cycles = 0;    ///< in the window
  [[no_unique_address]] StrokePace<Real> pace;
};

/// Marks the direction of every sample (1 ascending, 0 descending) and measures the
/// swing.
///
/// `u` is scaled to 0 … 1; `u_range` is its range in the unit of `oscillation.amplitude`.
/// A turning point is a retreat of 30 % of the range of u; where u drifts, so that this
/// finds fewer than one in a cycle of the oscillation, of 30 % of its usual swing. One
/// that is not quite regular enough to be detected counts where fewer than ten are found,
/// and what swings on a drift at all events where retreats of 15 or 10 % of the range
/// make ten, each eight samples or more from the next; neither on a bare board. The
/// period is the detected one, or else twice the median distance of turning points. Cost:
/// two passes. Stack: 256 turning points, 128 in the least sizes (limits.hpp); later ones
/// do not enter the medians.
template <class Real>
[[nodiscard]] Movement<Real> measure_movement(std::span<const Real> u,
                                              const OscillationReport<Real>& oscillation,
                                              Real u_range,
                                              std::span<unsigned char> ascending);

/// Whether `signal` turns back as often as `oscillation`, detected in it, says that it
/// cycles. The steps of a staircase repeat as cycles do, and do not turn back.
/// `amplitude`: of the oscillation, in the unit of the signal. One pass.
template <class Real>
[[nodiscard]] bool turns_in_cycles(std::span<const Real> signal,
                                   const OscillationReport<Real>& oscillation,
                                   Real amplitude);

/// The sample, about one period after the first, at which u is next where it was at the
/// first and moves the same way; 0 if the window is shorter than three periods.
template <class Real>
[[nodiscard]] std::size_t first_return(std::span<const Real> u,
                                       std::span<const unsigned char> ascending,
                                       Real period);

}  // namespace ident
