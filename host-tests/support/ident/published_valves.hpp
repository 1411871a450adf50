// Symmetric valves by the parameters of other models.
#pragma once

#include "ident/valve/stick_slip_valve.hpp"

namespace test {

/// Choudhury's: stick band plus deadband S, slip J. Kano's use the same; J ≤ S.
template <class Real>
ident::ValveFriction<Real> from_choudhury(Real s, Real j) {
  return {s - j, j, j, ident::SlipMotion::kStops};
}

/// He's: static band fs, kinetic band fd ≤ fs.
template <class Real>
ident::ValveFriction<Real> from_he(Real fs, Real fd) {
  return {Real(2) * fd, fs - fd, fs - fd, ident::SlipMotion::kResticks};
}

}  // namespace test
