// The trials behind explain(): each effect fitted, tested and compared with the others.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "workbench/effects/catalogue.hpp"
#include "workbench/model/explain.hpp"
#include "workbench/model/fit.hpp"

namespace workbench {

/// The answer with the fits it rests on.
struct Exploration {
  ExplainResult result;
  Fit base;                 ///< what was explained, searched further where that helped
  std::optional<Fit> best;  ///< with the effect (and partner) of result.best()
};

/// Explains what `base` leaves over of the fitter's recording, with the effects of
/// `catalogue` that it lacks. What after a first look leaves a squared error (Fit::error)
/// above `hopeless_above` is not searched further.
[[nodiscard]] Exploration explore(
    const Fitter& fitter, const Fit& base, const Catalogue& catalogue,
    const ExplainProgress& progress = {},
    double hopeless_above = std::numeric_limits<double>::infinity());

/// True where `effect` still earns its place in `fit`: without it, and everything else
/// fitted again, the validation error rises beyond chance.
[[nodiscard]] bool still_needed(const Fitter& fitter, const Fit& fit,
                                const Effect& effect, std::optional<Fit>& without);

}  // namespace workbench
