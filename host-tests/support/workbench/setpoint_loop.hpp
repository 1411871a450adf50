// A small closed loop for tests of the workbench's models: PI, setpoint steps, a
// first-order process, and one thing wrong with it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "workbench/recording/recording.hpp"

namespace workbench::test {

/// Gain 2 y/u, lag 20 s, one sample a second, PI with gain 0.6 u/y and reset 20 s, around
/// u = y = 50; setpoints of ± 10 y held for 100 s. Everything may be replaced.
struct SetpointLoop {
  std::size_t samples = 1200;
  std::uint64_t seed = 1000;
  double noise_std = 0.2;  ///< y
  double lag_s = 20;
  std::size_t delay = 0;  ///< samples between valve and process
  bool setpoint_moves = true;
  std::function<double(double u)> valve = [](double u) { return u; };
  /// Added to y before the controller sees it; k counts samples.
  std::function<double(std::size_t k)> load = [](std::size_t) { return 0.0; };
  /// From the output to what is recorded.
  std::function<double(double y)> sensor = [](double y) { return y; };
};

/// Columns t, u, y, sp and x (the valve's output at the start of the interval).
[[nodiscard]] Recording simulated(const SetpointLoop& loop);

/// The same process with u moved by hand: each of `levels` held for 150 samples.
[[nodiscard]] Recording stepped(std::span<const double> levels,
                                const std::function<double(double u)>& valve);

/// A backlash of the given width for `SetpointLoop::valve`.
[[nodiscard]] std::function<double(double)> backlash(double width);

/// A stem for `SetpointLoop::valve` that stays until u is 3 ahead and slips to 1 behind
/// it.
[[nodiscard]] std::function<double(double)> slipping();

}  // namespace workbench::test
