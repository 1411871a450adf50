// The knots of the paths: where they begin, and where the data want them.
#pragma once

#include "ident/two_path/lagged_gram.hpp"

namespace ident {

/// kMaxSegments of equal width on both paths, over 0 … 1.
template <class Real>
[[nodiscard]] KnotGrid<Real> uniform_grid();

/// Remark 4 (M9): drops knots inside flat stretches, then splits the segment that rises
/// most into three, if there is room and it is worth it. True when a segment was split.
template <class Real>
[[nodiscard]] bool refine_knots(Path<Real>& path);

}  // namespace ident
