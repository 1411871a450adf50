// What a plant historian makes of the signals of a loop.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "workbench/simulate/random.hpp"
#include "workbench/simulate/simulated_loop.hpp"

namespace workbench::test {

enum class Historian {
  kNone,          ///< every sample as it was
  kBoxcar,        ///< exception reporting: a value is held until the next differs enough
  kSwingingDoor,  ///< straight lines between the stored points
  kQuantised,     ///< u, y or both rounded
  kEverySecond,   ///< every second sample, or the mean of two
  kJitter,        ///< u and y read at instants of their own
};
inline constexpr int kHistorians = 6;
[[nodiscard]] std::string_view name(Historian historian);

/// Holds a value until one differs from it by more than `deviation`, at most `longest`
/// samples.
[[nodiscard]] std::vector<double> boxcar(const std::vector<double>& signal,
                                         double deviation, std::size_t longest);

/// Swinging-door compression (Bristol 1990): straight lines between stored points, no
/// sample further than `deviation` off its line.
[[nodiscard]] std::vector<double> swinging_door(const std::vector<double>& signal,
                                                double deviation);

[[nodiscard]] std::vector<double> quantise(const std::vector<double>& signal,
                                           double step);

/// Reads each sample up to `most` < 1 periods early or late. `held`: the signal is a
/// staircase (u), otherwise straight lines (y).
[[nodiscard]] std::vector<double> jitter(Random& random,
                                         const std::vector<double>& signal, double most,
                                         bool held);

/// Every second sample of all signals or, with `means`, the means of two.
void every_second(SimulatedLoop& loop, bool means);

/// Draws the settings of a historian and records u and y through it. Settings follow the
/// size of each signal: a dead band of 2 to 30 % of its standard deviation, 8 to 80 steps
/// in its range, half a period of jitter at most. The truth (x, y_clean) stays as it is
/// but for `kEverySecond`, which takes the samples of all.
void record(Random& random, Historian historian, SimulatedLoop& loop);

}  // namespace workbench::test
