// Two effects at once, for what shows only beside another.
#pragma once

#include <vector>

#include "workbench/model/search/trial.hpp"

namespace workbench {

/// Two effects together, from the better one on; kept only where each is needed. What
/// leaves a squared error above `hopeless_above` is not searched further. `trials` as
/// examined, each with one effect. `closest` gets the pairs that were searched to the
/// end, kept or not.
[[nodiscard]] std::vector<Trial> pairs_of(const Fitter& fitter, const Fit& base,
                                          const std::vector<Trial>& trials,
                                          double hopeless_above,
                                          std::vector<Trial>& closest);

}  // namespace workbench
