// The stick bands that are tried, in steps that do not depend on the window: what one
// window says of a rung can be added to what another says of it.
#pragma once

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

/// The symmetric valve of a rung and of a slip 0 … kSlips − 1; it slides until u turns.
template <class Real>
[[nodiscard]] ValveFriction<Real> rung_valve(int rung, int slip, Real span) {
  const Real band = rung_band(rung, span);
  const Real jump = band * Real(kSlipShares[static_cast<std::size_t>(slip)]);
  return {band - jump, jump, jump, SlipMotion::kSlides};
}

}  // namespace ident
