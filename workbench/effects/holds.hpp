// Readings that repeat: who held them, the sensor or the historian.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "workbench/effects/situation.hpp"
#include "workbench/recording/recording.hpp"

namespace workbench::effects {

/// What u says about the holds of y. While a sensor holds, the controller sees a constant
/// error: u rests or runs straight, and bends where the reading jumps. Where a historian
/// held what it stored, the controller saw y go on, and its u bends anywhere, or u was
/// held as well.
enum class Holder {
  kNobody,  ///< y does not hold, or a coarse resolution makes it (lattice_of)
  kSensor,
  kHistorian,
  kEither,  ///< u says nothing, as where it is moved by hand
};

/// Equal lengths. O(n).
[[nodiscard]] Holder who_holds(std::span<const double> u, std::span<const double> y);

/// Readings closer than this are the same but for rounding.
[[nodiscard]] double same_reading(double low, double high);

/// What a hold makes of `signal`, in place: it stands still where `reading` does.
void hold_like(std::span<const double> reading, double same, std::span<double> signal);

/// What is found in the readings themselves.
struct Held {
  std::size_t jumps = 0;  ///< from one reading to another
  double share = 0;       ///< of the samples that repeat the one before
  double least_jump = 0;  ///< 5 % of the jumps are smaller
  double usual_jump = 0;  ///< half of them are
};
[[nodiscard]] Held held_in(std::span<const double> reading, double same);

/// Whether more than half of the repeats, `repeated` of the samples, are instants that no
/// row was read for: the value before is held there.
[[nodiscard]] bool are_filled_in(const Situation& situation, double repeated);

/// True where hardly any reading comes more than `most` times, two or so: y is refreshed
/// nearly as often as it is recorded, and a sensor that sticks holds longer where y
/// turns. O(n).
[[nodiscard]] bool is_scanned_slowly(std::span<const double> reading, double same,
                                     std::size_t most);

/// Stretches in which a reading stands still that noise else moves at every sample.
struct Frozen {
  std::size_t least = 0;      ///< samples that the shortest is long; 0: there is none
  std::size_t stretches = 0;  ///< equal readings at least as long
  std::size_t samples = 0;    ///< in all of them
  std::size_t first = 0;      ///< where the longest begins
  std::size_t longest = 0;    ///< samples
};
/// Equal lengths. Nothing is frozen where readings repeat anyhow, as coarse or stored
/// ones do, where y comes to rest, at either end of its range, at the very beginning, or
/// where u stands still as well, though else it does not: the recorder held both. O(n log
/// n).
[[nodiscard]] Frozen frozen_in(std::span<const double> u, std::span<const double> y);

/// Equal readings of y from `least` samples on, [first, last), in the order of time: none
/// at the very beginning and none at `low` or `high`, the ends of its range, that it does
/// not leave by a jump twice as large as any move but those out of long runs. O(n).
[[nodiscard]] std::vector<SampleRange> standing_still(std::span<const double> y,
                                                      std::size_t least, double low,
                                                      double high);

}  // namespace workbench::effects
