// The stick bands that are tried, in steps that do not depend on the window: what one
// window says of a rung can be added to what another says of it.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "ident/base/elementary.hpp"
#include "ident/base/limits.hpp"
#include "ident/valve/stick_slip_valve.hpp"

namespace ident {

/// Rungs of the ladder: bands from kLowestRung of the span up, each kRungRatio times the
/// one below, the highest a sixth above the span.
inline constexpr int kRungs = 63;
inline constexpr double kLowestRung = 0.0002;
inline constexpr double kRungRatio = 1.15;
/// Slip jump over stick band at each rung: play, and a stem that sticks and slips.
inline constexpr std::array<float, 2> kSlipShares = {0.0F, 0.6F};
inline constexpr int kSlips = kSmallSizes ? 1 : static_cast<int>(kSlipShares.size());
inline constexpr int kLadderValves = kRungs * kSlips;

/// Stick band of a rung 0 … kRungs − 1, in the unit of `span`. Constant time.
template <class Real>
[[nodiscard]] Real rung_band(int rung, Real span) {
  return span * Real(kLowestRung) *
         elementary::pow(Real(kRungRatio), static_cast<Real>(rung));
}

/// Bands are tried from the one to the other share of the swing.
inline constexpr double kLowestShare = 0.04;
inline constexpr double kHighestShare = 1.25;

/// Rungs first … last; none where `last` is less.
struct RungRange {
  int first = kRungs;
  int last = -1;
};

/// Those that are tried.
template <class Real>
[[nodiscard]] RungRange rungs_within(Real swing, Real span) {
  RungRange range;
  for (int rung = 0; rung < kRungs; ++rung) {
    const Real band = rung_band(rung, span);
    if (band >= Real(kLowestShare) * swing && band <= Real(kHighestShare) * swing) {
      range.first = std::min(range.first, rung);
      range.last = rung;
    }
  }
  return range;
}

/// The symmetric valve of a rung and of a slip 0 … kSlips − 1; it slides until u turns.
template <class Real>
[[nodiscard]] ValveFriction<Real> rung_valve(int rung, int slip, Real span) {
  const Real band = rung_band(rung, span);
  const Real jump = band * Real(kSlipShares[static_cast<std::size_t>(slip)]);
  return {band - jump, jump, jump, SlipMotion::kSlides};
}

}  // namespace ident
