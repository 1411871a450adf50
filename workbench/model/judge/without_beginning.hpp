// (W27) What a fit would be without the first samples of its recordings.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "workbench/model/base/blocks.hpp"

namespace workbench {

/// The first samples of each piece: a twentieth of it, five at least, of those that are
/// fitted. No pieces: one of the whole recording.
[[nodiscard]] std::vector<SampleRange> beginnings(std::span<const Piece> pieces,
                                                  const Blocks& blocks);

/// What leaving `begun` out would do to each parameter of a linear fit, where what is
/// missing in a model shows most: what was underway before the recording. `jacobian`: of
/// the residual, a column for each parameter, 0 where nothing is fitted; `residual`: at
/// the fit. Cost: one pass over each pair of columns.
struct WithoutBeginning {
  WithoutBeginning(const std::vector<std::vector<double>>& jacobian,
                   std::span<const double> residual, const Blocks& blocks,
                   std::span<const SampleRange> begun);

  /// Half the width of an interval of parameter `i`: `width`, or what holds its value
  /// without the beginnings, too, where that lies farther away than chance would bring it
  /// (Hausman 1978: the difference of two estimates has the difference of their
  /// variances).
  [[nodiscard]] double minding(double width, std::size_t i) const;

  std::vector<double> moved;     ///< each in its own unit
  std::vector<double> variance;  ///< over that of the whole fit, at the same noise; ≥ 1
  double noise = 1;  ///< mean squared error without the beginnings over that of all
};

}  // namespace workbench
