// An effect that is added without what the rest of the model had found being lost.
#pragma once

#include "workbench/model/fit/fit.hpp"

namespace workbench {

/// True where `now` leaves more than `before` over all samples, or on those that were not
/// fitted.
[[nodiscard]] bool loses_step(const Fitter& fitter, const Fit& before, const Fit& now);

/// `now`, which is `before` with `added`. Where that loses step, for a stem that now
/// slips at other samples, say, `added` is searched again with all else as it is in
/// `before`, and taken so where that leaves less over all samples and on those that were
/// not fitted, and no more than `before` on the others. It may still lose step: then the
/// recording speaks against the effect. Cost where it loses step: one thorough search.
[[nodiscard]] Fit in_step(const Fitter& fitter, const Fit& before, Fit now,
                          const Effect& added);

}  // namespace workbench
