// What several effects share: friction, a curve, starts for lags, moves of u.
#pragma once

#include <span>
#include <vector>

#include "ident/stick_slip_valve.hpp"
#include "workbench/effects/effect.hpp"

namespace workbench::effects {

/// Ten starts for a lag, from half a sample period to three times the first lag.
[[nodiscard]] std::vector<Values> lag_starts(const Situation& situation);

/// Reversals of u by more than a tenth of its span, for what any move of u shows.
[[nodiscard]] Excitation moves_of_u(const Situation& situation);

/// Drives the signal through a stem with friction that rests at v[0]; sets `at_rest`.
void move_with_friction(const ident::ValveFriction<double>& friction,
                        ValveSignal& signal);

/// A monotone curve over from … to with both ends fixed, whose slope changes by the
/// factor exp(curvature) from one end to the other (equal percentage above 0).
void bend_curve(double curvature, double from, double to, std::span<double> signal);

/// curvature, from, to.
[[nodiscard]] std::vector<SearchedParameter> curve_parameters(const Situation& situation);
[[nodiscard]] std::vector<Values> curve_starts(const Situation& situation);

}  // namespace workbench::effects
