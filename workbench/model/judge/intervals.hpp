// 95 % intervals of everything that a fit estimated.
#pragma once

#include <vector>

#include "workbench/model/fit/fit.hpp"
#include "workbench/model/judge/derived.hpp"

namespace workbench {

/// Intervals of a fit: searched parameters as in Fit::slots (constants: the value twice,
/// or the value divided and multiplied by SearchedParameter::within_factor), solved ones
/// as in Fit::columns.
struct FitIntervals {
  std::vector<Interval> searched;
  std::vector<Interval> solved;
  std::vector<DerivedValue> derived;  ///< of all effects, in their order
};

/// From the linearised error with the colour of the residual (sandwich: Jᵀ R J between
/// the inverses), 1.96 standard deviations. The numeric derivative takes a step in which
/// the error changes by more than noise; where a parameter can move without changing the
/// error (a limit between two samples), that play is added. Lags are multiplicative.
/// Intervals end at the physical bounds. Cost: some ten runs for each parameter.
[[nodiscard]] FitIntervals intervals_of(const Fitter& fitter, const Fit& fit);

/// (W8) The same; where any parameter is jumpy, by a random walk over all of them, since
/// the error then has many small valleys (random_walk.hpp). A residual that is not white
/// widens it. Cost: some thousand runs.
[[nodiscard]] FitIntervals thorough_intervals_of(const Fitter& fitter, const Fit& fit);

/// What the squared error must rise by to be more than noise, at 95 %: noise as large as
/// slow averages show it, at most 30 times that of a sample.
[[nodiscard]] double least_rise(const Fitter& fitter, const Fit& fit);

}  // namespace workbench
