#include "ident/two_path/knots.hpp"

namespace ident {

template <class Real>
KnotGrid<Real> uniform_grid() {
  KnotGrid<Real> grid;
  for (Path<Real>* path : {&grid.ascending, &grid.descending}) {
    path->segments = kMaxSegments;
    for (int i = 0; i <= kMaxSegments; ++i) {
      path->knots[i] = static_cast<Real>(i) / Real(kMaxSegments);
    }
  }
  return grid;
}

template <class Real>
bool refine_knots(Path<Real>& path) {
  constexpr Real kFlat = Real(1e-3);  // of the whole rise
  constexpr Real kWorthSplitting = Real(0.15);
  constexpr Real kNarrowest = Real(0.02);  // of the range of u
  const Real rise = path.x[path.segments] - path.x[0];
  if (!(rise > Real(0))) {
    return false;
  }
  Path<Real> merged = path;
  int last = 0;
  for (int k = 1; k < path.segments; ++k) {
    const bool flat_before = path.x[k] - path.x[k - 1] < kFlat * rise;
    const bool flat_after = path.x[k + 1] - path.x[k] < kFlat * rise;
    if (!(flat_before && flat_after)) {
      ++last;
      merged.knots[last] = path.knots[k];
      merged.x[last] = path.x[k];
    }
  }
  ++last;
  merged.knots[last] = path.knots[path.segments];
  merged.x[last] = path.x[path.segments];
  merged.segments = last;
  path = merged;

  int steepest = -1;
  Real most = kWorthSplitting * rise;
  for (int k = 0; k < path.segments; ++k) {
    const Real step = path.x[k + 1] - path.x[k];
    if (step > most && path.knots[k + 1] - path.knots[k] > kNarrowest) {
      most = step;
      steepest = k;
    }
  }
  if (steepest < 0 || path.segments + 2 > kMaxSegments) {
    return false;
  }
  for (int k = path.segments; k > steepest; --k) {
    path.knots[k + 2] = path.knots[k];
    path.x[k + 2] = path.x[k];
  }
  path.segments += 2;
  const Real knot = path.knots[steepest];
  const Real x = path.x[steepest];
  const Real width = (path.knots[steepest + 3] - knot) / Real(3);
  const Real step = (path.x[steepest + 3] - x) / Real(3);
  for (int i = 1; i <= 2; ++i) {
    path.knots[steepest + i] = knot + static_cast<Real>(i) * width;
    path.x[steepest + i] = x + static_cast<Real>(i) * step;
  }
  return true;
}

template KnotGrid<float> uniform_grid<float>();
template KnotGrid<double> uniform_grid<double>();
template bool refine_knots<float>(Path<float>&);
template bool refine_knots<double>(Path<double>&);

}  // namespace ident
