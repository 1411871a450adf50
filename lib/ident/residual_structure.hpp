// Whether anything is left in a residual that another model could explain.
#pragma once

#include <span>

namespace ident {

/// How far the residual y − simulated is from Gaussian white noise, in standard
/// deviations, the larger of two: how much longer it keeps its sign, the largest of
/// Σ r(k)·√(n/K) over k = 1 … K and K = 1, 2, 4, 8, 16 with r the autocorrelation; and
/// its excess kurtosis, √(n/24)·(m₄/m₂² − 3). A valve that is modelled wrongly shifts the
/// output for as long as the process remembers, or for the moment by which its slips come
/// too early. White noise exceeds 2 in one case of ten. 0 for an error of 0 or fewer than
/// 32 samples. Cost: one pass.
template <class Real>
[[nodiscard]] Real residual_structure(std::span<const Real> y,
                                      std::span<const Real> simulated);

}  // namespace ident
