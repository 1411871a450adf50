// A fit as data: what is written to a file, shown and read back.
#pragma once

#include <vector>

#include "workbench/model/base/model.hpp"
#include "workbench/model/judge/intervals.hpp"

namespace workbench {

/// What is told of a fit.
struct ToldFit {
  Fit fit;  ///< with_absent_limits()
  FitIntervals intervals;
};
[[nodiscard]] ToldFit told_of(const Fitter& fitter, const Fit& found);

/// The fit as data, with its intervals; history is left to the caller.
[[nodiscard]] Model model_of(const Fitter& fitter, const Fit& fit);
[[nodiscard]] Model model_of(const Fitter& fitter, const ToldFit& told);

/// The intervals that are told of a fit: thorough ones, which end where an effect would
/// be absent and the error says that it is not.
[[nodiscard]] FitIntervals told_intervals_of(const Fitter& fitter, const Fit& fit);

/// The fit with each limit that may as well lie where it would be absent (W22) laid
/// there, as long as the error is as small then: what is told is what was fitted.
[[nodiscard]] Fit with_absent_limits(const Fitter& fitter, Fit fit,
                                     const FitIntervals& intervals);

/// The parameters of one effect in a fit (of the process: null): searched ones first,
/// then what follows from them, then solved ones.
[[nodiscard]] std::vector<Parameter> parameters_of(const Fit& fit,
                                                   const FitIntervals& intervals,
                                                   const Effect* effect);

}  // namespace workbench
