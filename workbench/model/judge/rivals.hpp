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
/// told from it; for one of the record only another of the record; stiction for backlash
/// that leaves_slip_open(). Cost: one trial of each effect that `fit` lacks.
[[nodiscard]] std::vector<std::string> rivals_of(const Fitter& fitter, const Fit& fit,
                                                 const Effect& effect,
                                                 const Catalogue& catalogue);

/// True for backlash, which is stiction without the slip, where `other` is stiction.
[[nodiscard]] bool lacks_slip(const Effect& effect, const Effect& other);

/// (W14) True where the moves of u that would show a slip jump are missing: `play`, a fit
/// with backlash, is not told from `stuck`, the same with stiction instead, searched
/// again with slip jumps of half the deadband of `play`. Cost: a search.
[[nodiscard]] bool leaves_slip_open(const Fitter& fitter, const Fit& play,
                                    const Fit& stuck);

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
