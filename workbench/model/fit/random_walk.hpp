// Which other values of the parameters a recording allows, where the error has steps.
#pragma once

#include <vector>

#include "workbench/model/fit/free_run.hpp"

namespace workbench {

/// Points that a random walk visited, one row each.
struct Walk {
  std::vector<std::vector<double>> p;  ///< search coordinates (parameter_search.hpp)
  std::vector<std::vector<double>> coefficients;  ///< as in FreeRun::columns
};

/// Metropolis walk over the searched parameters from `start` (as in slots, within
/// bounds), for errors with the density exp(−½·E/variance), E the squared error on the
/// estimation blocks and a flat prior within the bounds. `scale`: a first guess of the
/// standard deviations, search coordinates, as in slots; the walk learns its own, with
/// their correlations (Haario, Saksman and Tamminen 2001). The first quarter is left
/// out. Cost: `steps` runs. Deterministic.
[[nodiscard]] Walk walk_around(FreeRun& run, const std::vector<double>& start,
                               const std::vector<double>& scale, double variance,
                               int steps);

}  // namespace workbench
