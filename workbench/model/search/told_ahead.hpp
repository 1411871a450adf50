// Effects that a load hides from the free run, and that one sample ahead tells.
#pragma once

#include <optional>
#include <vector>

#include "workbench/model/search/trial.hpp"

namespace workbench {

/// (W44) Where the load wanders and none of `trials` is accepted: of those between the
/// valve's signal and the reading, the one that foretells the output best, one sample
/// ahead, beside the past of what is left. Each model is simulated freely and fitted
/// under the noise colour that suits it (FreeRun::weigh_by). It is accepted, and those
/// that foretell as well are named beside it; null where none tells beyond doubt. Cost:
/// some twenty refinements for each effect.
[[nodiscard]] Trial* tell_ahead(const Fitter& fitter, const Fit& base,
                                std::vector<Trial>& trials);

struct ToldAhead {
  Fit fit;
  AheadErrors errors;
};

/// The same for one effect beside `base`, whatever is left, of which `start` is a fit;
/// nothing where one sample ahead does not tell it either.
[[nodiscard]] std::optional<ToldAhead> told_ahead(const Fitter& fitter, const Fit& base,
                                                  const Fit& start, const Effect& effect,
                                                  std::size_t many = 1);

/// Leaves undecided what was accepted with a column of the recording that does not
/// foretell the output one sample ahead: two things that wander look alike by chance.
void leave_columns_open(const Fitter& fitter, std::vector<Trial>& trials);

}  // namespace workbench
