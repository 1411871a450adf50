// Whether the sensor sticks: its reading holds while the process goes on, then jumps.
#pragma once

#include <cstddef>
#include <span>

namespace ident {

/// Of a hold, and of those that make a sensor stick: readings, number, share of the
/// samples. Those of noisy_hold.hpp, too.
inline constexpr std::size_t kShortestHold = 5;
inline constexpr std::size_t kFewestHolds = 8;
inline constexpr double kLeastHeld = 0.4;
/// A record of fewer samples says nothing of its sensor.
inline constexpr std::size_t kFewestForHolds = 64;

/// What speaks for a sticking sensor. A hold is a run of at least 5 equal readings.
struct SensorHold {
  bool sticks = false;    ///< nearly certain: all of the below
  std::size_t holds = 0;  ///< number of holds; at least 8
  double held = 0;        ///< share of the samples in holds, 0 … 1; at least 0.4
  double jumps = 0;       ///< share of the holds that end in a single jump to the next
                          ///< hold or reading, 0 … 1; at least 0.6
  double driven = 0;    ///< share of the holds in which u runs on, straight; at least 0.8
  double answered = 0;  ///< share of the jumps that u answers at once; at least 0.8
  double wander = 0;  ///< mean distance of a level from the last but one, in mean jumps;
                      ///< at least 0.03
  double resolution = 0;  ///< smallest difference of levels, in mean jumps; at most 0.1,
                          ///< and half of `wander`
  double smallest_jump = 0;  ///< that ends a hold, in mean jumps; at least 0.1, and twice
                             ///< `resolution`
};

/// While the reading y holds, the controller integrates a constant error: u runs on along
/// a straight line, the true value follows, and at the end the reading jumps from one
/// sample to the next, whatever the dynamics of the process; u answers in that sample.
///
/// A sticking valve makes y flat while u runs on as well, but a flat that is measured
/// has noise, and drifts with the load: its readings do not repeat exactly. Where they
/// do, the resolution is coarse beside the jumps, or no load moves the levels of the
/// holds from cycle to cycle. Exception reporting holds what the controller never saw
/// held: u does not run straight then, nor bend at the jumps.
///
/// What it cannot tell, and so stays silent about: a sensor that holds with noise on top,
/// or whose resolution is coarse; a setpoint that moves in the holds. In a loop without
/// noise and load a valve that sticks before a process faster than the sampling gives the
/// very same u and y; one such in ten is named a sensor. Offset and scale do not matter.
///
/// Equal lengths. Cost: five passes.
[[nodiscard]] SensorHold find_sensor_hold(std::span<const double> u,
                                          std::span<const double> y);

}  // namespace ident
