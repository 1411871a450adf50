// Which hats the increments of a structure stand for.
#pragma once

#include <Eigen/Core>
#include <array>

#include "ident/two_path/lagged_gram.hpp"
#include "ident/two_path/two_path_iteration.hpp"

namespace ident {

/// Where one increment of a coarse path lies among the hats: the step functions
/// first … last − 1 (1 from hat i on), averaged.
struct StepRange {
  Eigen::Index first;
  Eigen::Index last;
};

/// The unknown increments of one structure over a grid, ascending first.
template <class Real>
struct Layout {
  Layout(const KnotGrid<Real>& grid, const Structure& s) {
    const auto add = [this](int offset, int fine, int coarse) {
      const int width = fine / coarse;
      for (int k = 0; k < coarse; ++k) {
        ranges[count++] = {offset + k * width + 1, offset + (k + 1) * width + 1};
      }
    };
    add(0, grid.ascending.segments, s.segments_ascending);
    add(grid.ascending.segments + 1, grid.descending.segments, s.segments_descending);
  }
  std::array<StepRange, 2 * kMaxSegments> ranges;
  int count = 0;
};

}  // namespace ident
