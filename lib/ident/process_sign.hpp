// The sign of the process gain where the controller does not tell it.
#pragma once

#include <span>

#include "ident/process_regression.hpp"

namespace ident {

/// ±1: the sign with which a linear valve and a process with one pole explain more of y.
/// A guess only: where y moves u, the other way round may fit better. `period` of the
/// oscillation in samples; `scratch`: as long as y. Cost: twelve passes of
/// ProcessRegression::screen.
template <class Real>
[[nodiscard]] int likelier_sign(std::span<const Real> u, std::span<const Real> y,
                                Real period, ProcessRegression<Real>& regression,
                                std::span<Real> scratch);

}  // namespace ident
