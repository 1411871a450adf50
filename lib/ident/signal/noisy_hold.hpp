// Whether y holds a value with nothing on it but white noise while u runs on.
#pragma once

#include <cstddef>
#include <span>

namespace ident {

/// What speaks for a sensor that sticks and has noise behind it. A hold is a run of at
/// least 5 readings that stay within 4.5 standard deviations of the noise around their
/// mean.
struct NoisyHold {
  bool sticks = false;    ///< nearly certain: all of the below
  std::size_t holds = 0;  ///< at least 8
  double held = 0;        ///< share of the samples in holds, 0 … 1; at least 0.4
  double whiteness = 0;   ///< variance in the holds over half the mean square of the
                          ///< differences there, which is 1 for white noise; at most 1.1
  double wander = 0;      ///< mean square by which a level differs from the last but one,
                          ///< in what the noise makes of it; at least 9
  double tail = 0;    ///< how far a hold begins on the side that y came from, in standard
                      ///< errors; at most 3
  double driven = 0;  ///< u integrates what is held: r² of its rates with the levels of
                      ///< the holds, 0 … 1; at least 0.5
};

/// A reading that is held does not move with the load, nor with what is left of the last
/// move of the process; what comes after the sensor, noise of the transmitter and of the
/// wire, is white. Behind a sticking valve y is flat, too, but as coloured as ever: a
/// load that moves the level from one hold to the next moves it in the holds as well.
/// That the levels do wander says that there is such a load.
///
/// What it cannot tell: a sensor that slides along for most of the time, and a valve
/// whose slip jumps differ from one to the next in a fast process without any load, which
/// looks like a sensor. Holds without noise are those of sensor_hold.hpp. Offset and
/// scale do not matter.
///
/// Cost: eight passes.
[[nodiscard]] NoisyHold find_noisy_hold(std::span<const double> u,
                                        std::span<const double> y);

}  // namespace ident
