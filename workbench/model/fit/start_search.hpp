// From the starts of a search to the valley that the fit ends in.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "workbench/model/fit/free_run.hpp"
#include "workbench/model/fit/parameter_search.hpp"

namespace workbench {

/// How thoroughly to search.
enum class Effort {
  kScreen,    ///< a few milliseconds: is it worth a closer look?
  kThorough,  ///< several starts, to the end
};

/// On from a point into the valley it lies in; thoroughly, where an effect has trades,
/// also from valleys around it, as long as what is left is not white.
[[nodiscard]] SearchPoint search_on(FreeRun& run, SearchPoint point, Effort effort);

/// (W44) To the deepest of the valleys around a point, up to eight rows of the recording
/// to either side, in each delay that is searched: behind a noise colour the error has
/// one at every whole row. The point itself where errors are not weighed. Cost: 16 runs
/// for each delay and a descent, three times at most.
[[nodiscard]] SearchPoint at_deepest_delay(FreeRun& run, SearchPoint point);

/// Slot of the first lag of the process; an integrating one has none.
[[nodiscard]] std::optional<std::size_t> first_lag_slot(const FreeRun& run);

/// (W43) Where the search for the process ends that begins at `p`, with the closest of
/// all first lags, in factors of two; or in another valley of these, where that leaves
/// less than half on the whole recording: with a lag as long as what is fitted, and a
/// free state where it begins, a process takes the shape of any curve, and fails where it
/// is judged.
[[nodiscard]] SearchPoint first_found(FreeRun& run, std::vector<double> p);

/// Where a search for one more effect may start, and the first lags that each of the
/// starts is judged with: all with the first few, the best with the rest.
struct Starts {
  std::vector<std::vector<double>> p;  ///< as in FreeRun::slots
  std::vector<double> lags_s;          ///< one entry, unused, where there is no first lag
  std::size_t few_lags = 0;
};

/// The starts, each with its best lag; smallest error first. Cost: a run for each start
/// and lag.
[[nodiscard]] std::vector<SearchPoint> judged(const FreeRun& run, const Starts& starts);

/// What a search has seen of its starts; a more thorough one of the same goes on from it.
struct ScreenedStarts {
  std::vector<SearchPoint> points;  ///< as judged() says; empty: nothing yet
  std::vector<std::optional<SearchPoint>> valleys;  ///< of those that were followed
};

/// The best of what is found from the points of `seen`, at least one. A thorough search
/// ends early where its best start still leaves more than `hopeless_above`.
[[nodiscard]] SearchPoint followed(const FreeRun& run, ScreenedStarts& seen,
                                   Effort effort, double hopeless_above);

}  // namespace workbench
