// How much of a signal the textbook model leaves over: first-order process, linear valve,
// no dead time, free simulation from u, every parameter fitted to all samples.
#pragma once

#include <span>

namespace hidden {

/// Root mean square error of the best textbook model of `y` driven by `u`, units of y.
/// Gain, offset and initial state by least squares for each time constant; time constants
/// from a third of a sample to the length of the recording, on a fine grid, then refined.
/// Cost: about 100 passes over the samples.
[[nodiscard]] double textbook_misfit(std::span<const double> u,
                                     std::span<const double> y);

}  // namespace hidden
