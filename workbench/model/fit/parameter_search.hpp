// The bounded search over the nonlinear parameters of a free run.
#pragma once

#include <functional>
#include <vector>

#include "workbench/model/fit/free_run.hpp"

namespace workbench {

/// A point of the search and its sum of squared errors on the estimation blocks.
struct SearchPoint {
  std::vector<double> p;
  double error = 0;
};

/// Calls `part` for 0 … count - 1 with a run of its own for every `at_once` of them, on
/// all threads of `run`'s work. Throws what the parts throw.
void each(const FreeRun& run, std::size_t count, std::size_t at_once,
          const std::function<void(FreeRun&, std::size_t)>& part);

/// Simulates `p` (values outside their bounds are moved to the bound).
[[nodiscard]] SearchPoint evaluate(FreeRun& run, std::vector<double> p);

/// Levenberg-Marquardt with a numeric Jacobian, inside the bounds; lags and rates by
/// their logarithm. At most `iterations`; one costs as many runs as there are searched
/// parameters, plus one to five. Never worse than `start`. `run` is left at another
/// point: call evaluate() for residual and coefficients of the result.
/// `jumpy_step` is the step of the derivative for jumpy parameters, in search
/// coordinates: wide to see over steps, narrow to end exactly.
inline constexpr double kWideStep = 4e-3;
inline constexpr double kNarrowStep = 2e-4;
[[nodiscard]] SearchPoint descend(FreeRun& run, SearchPoint start, int iterations,
                                  double jumpy_step = kWideStep);

/// Pattern search (Hooke & Jeeves 1961) over single parameters and, for effects with
/// several jumpy ones, their trades; for errors with steps. At most `evaluations` runs.
[[nodiscard]] SearchPoint pattern(FreeRun& run, SearchPoint start, int evaluations);

/// Which of its bounds a value rests on, where that means more than that it is off.
enum class Edge { kNone, kLow, kHigh };
[[nodiscard]] Edge edge_of(const SearchedParameter& parameter, double value);

/// `point`, less the edges that nothing asks for: a jumpy parameter that rests on one is
/// moved 2 % of its range inside where that costs less than half a nat, as the width of a
/// play that no reversal crosses. One run for each.
[[nodiscard]] SearchPoint off_edges(FreeRun& run, SearchPoint point);

/// The best `count` points of a grid around `start`, best first, for errors with many
/// small valleys: the jumpy parameters of an effect scaled by up to 12 %, the first
/// traded for the others, and other first lags. Cost: 273 runs for each effect with
/// trades.
[[nodiscard]] std::vector<SearchPoint> around(const FreeRun& run,
                                              const SearchPoint& start,
                                              std::size_t count);

/// True where an effect has several jumpy parameters that may be traded.
[[nodiscard]] bool has_trades(const FreeRun& run);

/// True where any parameter that is searched is jumpy.
[[nodiscard]] bool has_jumpy(const FreeRun& run);

/// Coordinates in which the searches step, and back: logarithm or share of the range.
[[nodiscard]] double to_search(const SearchedParameter& parameter, double value);
[[nodiscard]] double from_search(const SearchedParameter& parameter, double coordinate);

}  // namespace workbench
