// Loops whose valve follows, under loads that nobody recorded.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "workbench/recording/recording.hpp"

namespace score {

inline constexpr std::array kShapes = {"steps", "unequal steps", "four levels", "ramps",
                                       "saw",   "trapezes",      "lags",        "waves"};

enum class Times {
  kItsOwn,  ///< the load comes back, exactly or by periods that vary by 2 or 5 %
  kAny,     ///< it is on or off for times of any length
};

struct ClockedLoop {
  workbench::Recording recording;
  std::size_t shape = 0;  ///< of kShapes
  double jitter = 0;      ///< of the periods
  std::size_t every = 1;  ///< of how many samples of the controller one is recorded
};

/// PI control of a first- or second-order or an integrating process, dead time in half of
/// them, the load before or behind the process. The same for a seed on every machine.
[[nodiscard]] ClockedLoop clocked_loop(std::uint64_t seed, Times times);

}  // namespace score
