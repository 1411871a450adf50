// Whether an effect is told from none: by its intervals or by the profile of the error.
#pragma once

#include "workbench/model/fit/fit.hpp"
#include "workbench/model/judge/intervals.hpp"

namespace workbench {

/// True where an interval of the effect excludes "off". That of two lags of equal length,
/// or of a curve beside a lag that follows it, has no end in a linearised error; where
/// the error is smooth its profile is asked, too: how it rises when the effect is taken
/// out and the rest is fitted again.
[[nodiscard]] bool excludes_off(const Fitter& fitter, const Fit& fit,
                                const FitIntervals& intervals, const Effect& effect);

/// True where no interval of the effect excludes "off": not those of a random walk
/// either, where the error has steps. Other than excludes_off() this says what is told of
/// the values, not whether the data want the effect.
[[nodiscard]] bool holds_off(const Fit& fit, const FitIntervals& intervals,
                             const Effect& effect);

/// The same as excludes_off(), and ends `intervals` where the profile does: where those
/// of the effect hold "off" although excludes_off(), they end on both sides at the value
/// beyond which the error, with all else fitted again, rises by more than noise. Where
/// the profile holds "off", too, they stay. Cost: some thorough searches where they hold
/// it.
bool end_by_profile(const Fitter& fitter, const Fit& fit, const Effect& effect,
                    FitIntervals& intervals);

}  // namespace workbench
