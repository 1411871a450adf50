// Which way the controller acts, and so which sign the process gain has.
#pragma once

#include <span>

namespace ident {

/// What the controller does, seen from Δu against Δe and e, e = sp − y.
template <class Real>
struct ControllerAction {
  int sign = 0;  ///< of the process gain, as negative feedback needs it; 0 unknown
  Real proportional = 0;  ///< Δu for Δe, units of u per unit of y
  Real integral = 0;      ///< Δu per sample for e, units of u per unit of y
  Real r_squared = 0;     ///< share of Δu that the PI law explains, 0 … 1
};

/// Fits Δu(t) = Kc·Δe(t) + Ki·e(t) + c by least squares. A valve and a process never act
/// on y within the sample, so this is the controller, not the plant, read from the same
/// data. Samples at the lowest or highest u are left out: there a controller that
/// saturates does not follow its law. `sign` is given only if the law explains nearly all
/// of Δu, or most of it and clearly more than the same law one sample later, and its two
/// parts do not disagree. `sp` may be empty (constant setpoint). Cost: six passes.
template <class Real>
[[nodiscard]] ControllerAction<Real> controller_action(std::span<const Real> u,
                                                       std::span<const Real> y,
                                                       std::span<const Real> sp);

}  // namespace ident
