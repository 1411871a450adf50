// What could stand in a model instead of one of its effects.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workbench/effects/catalogue.hpp"
#include "workbench/model/fit.hpp"

namespace workbench {

/// Effects of `catalogue` that could stand in `fit` for `effect`: what they make of the
/// validation samples cannot be told from it. Asked are those that show in the same view
/// and those whose codes are in `also`.
[[nodiscard]] std::vector<std::string> rivals_of(
    const Fitter& fitter, const Fit& fit, const Effect& effect,
    const Catalogue& catalogue, const std::vector<std::string>& also = {});

/// `fit` with a simpler effect at the same place instead of `effect` (backlash instead of
/// stiction), where the data do not miss the rest; nothing otherwise.
[[nodiscard]] std::optional<Fit> simplified(const Fitter& fitter, const Fit& fit,
                                            const Effect& effect,
                                            const Catalogue& catalogue);

}  // namespace workbench
