// What could stand in a model instead of one of its effects.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workbench/effects/catalogue.hpp"
#include "workbench/model/fit/fit.hpp"

namespace workbench {

/// Effects of `catalogue` that could stand in `fit` for `effect`: possible themselves,
/// not far richer in parameters, and what they make of the validation samples cannot be
/// told from it. Cost: one trial of each effect that `fit` lacks.
[[nodiscard]] std::vector<std::string> rivals_of(const Fitter& fitter, const Fit& fit,
                                                 const Effect& effect,
                                                 const Catalogue& catalogue);

/// `rest`, which is `fit` less an effect, with `other` in its place where that is one of
/// rivals_of().
[[nodiscard]] std::optional<Fit> replaced(const Fitter& fitter, const Fit& fit,
                                          const Fit& rest, const Effect& other);

/// `fit` with a simpler effect at the same place instead of `effect` (backlash instead of
/// stiction), where the data do not miss the rest; nothing otherwise.
[[nodiscard]] std::optional<Fit> simplified(const Fitter& fitter, const Fit& fit,
                                            const Effect& effect,
                                            const Catalogue& catalogue);

}  // namespace workbench
