// The trials behind explain(): each effect fitted, tested and compared with the others.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "workbench/effects/catalogue.hpp"
#include "workbench/model/fit/fit.hpp"
#include "workbench/model/search/explain.hpp"
#include "workbench/model/search/identified.hpp"

namespace workbench {

/// The answer with the fits it rests on.
struct Exploration {
  ExplainResult result;
  Fit base;                 ///< what was explained, searched further where that helped
  std::optional<Fit> best;  ///< with the effect (and partner) of result.best()
};

/// Explains what `base` leaves over of the fitter's recording, with the effects of
/// `catalogue` that it lacks. What after a first look leaves a squared error (Fit::error)
/// above `hopeless_above` is not searched further. `identified` is asked where a stem is
/// accepted. (W12)
[[nodiscard]] Exploration explore(
    const Fitter& fitter, const Fit& base, const Catalogue& catalogue,
    Identified& identified, const ExplainProgress& progress = {},
    double hopeless_above = std::numeric_limits<double>::infinity());

/// Those of `known` that the recording can judge: where pieces of it judge, none that
/// stays_behind() (free_run.hpp), but for `kept`.
[[nodiscard]] Catalogue judged_by(const Recording& recording, const Catalogue& known,
                                  const std::vector<std::string>& kept);

/// Adds to the candidates of `result`, as undecided, what `known` has above `judged` and
/// the model, with the effects `held`, has not.
void leave_open(const Recording& recording, const Catalogue& known,
                const Catalogue& judged, const std::vector<std::string>& held,
                ExplainResult& result);

/// True where `effect` still earns its place in `fit`: it shows_itself(), or without it,
/// and everything else fitted again, the validation error rises beyond chance, and an
/// instant of it is told (untold_instant.hpp).
[[nodiscard]] bool still_needed(const Fitter& fitter, const Fit& fit,
                                const Effect& effect, std::optional<Fit>& without);

}  // namespace workbench
