// What the values of one signal tell before any model: resolution, limits, shape.
#pragma once

#include <span>

namespace ident {

/// Distance of the levels that the values lie on, 0 where no such lattice is seen or it
/// has more than 100 levels. Sorts `values` in place; cost: one sort.
template <class Real>
[[nodiscard]] Real level_step(std::span<Real> values);

/// Share of the samples, 0 … 1, that the signal spends in rests of two samples or more
/// at its lowest or its highest value: a controller output at its limit. One pass.
template <class Real>
[[nodiscard]] Real share_at_limits(std::span<const Real> values);

/// Kurtosis: 1 for a square wave, 1.5 for a sinusoid of constant size, 3 for a normal
/// distribution, and so for a resonance that noise keeps ringing. 0 where the values do
/// not differ. Two passes.
template <class Real>
[[nodiscard]] Real kurtosis(std::span<const Real> values);

}  // namespace ident
