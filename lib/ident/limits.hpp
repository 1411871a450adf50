// Sizes that bound every array and every loop of the identifier.
#pragma once

namespace ident {

/// Highest number of output lags a_1 … a_na of the process, equation (1).
inline constexpr int kMaxNa = 4;
/// Highest number of input lags b_1 … b_nb of the process, equation (1).
inline constexpr int kMaxNb = 4;
/// Longest dead time beyond one sample, in samples, equation (1).
inline constexpr int kMaxNk = 12;
/// Most segments (slopes) of one valve path, equation (2).
inline constexpr int kMaxSegments = 12;
/// Most knots of one valve path, equation (2).
inline constexpr int kMaxKnots = kMaxSegments + 1;
/// Most hats, one a knot, of both paths together.
inline constexpr int kMaxHats = 2 * kMaxKnots;

}  // namespace ident
