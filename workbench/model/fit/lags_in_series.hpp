// Which of two lags in series is that of the process.
#pragma once

#include <vector>

#include "workbench/model/fit/free_run.hpp"

namespace workbench {

/// True for a lag beside that of the process.
[[nodiscard]] bool is_lag(const Effect* effect);

/// (W23) A point with the slowest lag as that of the process: by convention, for two lags
/// in series give the same output either way round, and a sensor or a positioner is meant
/// to be faster than the process. Where the other way round fits worse by more than two
/// nats, as with a load that only one of them delays, `p` stays. `run` is left at another
/// point. Cost: a few iterations of a search for each lag that is slower than the first.
[[nodiscard]] std::vector<double> slowest_first(FreeRun& run, std::vector<double> p);

}  // namespace workbench
