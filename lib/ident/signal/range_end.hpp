// Whether a reading rests at an end of its range, where it no longer follows what it
// measures.
#pragma once

#include <cstddef>
#include <span>

namespace ident {

/// An end of the range, where y is cut off: a transmitter at 4 or 20 mA, a tank that is
/// full or empty.
struct RangeEnd {
  double level = 0;       ///< the reading there, units of y
  std::size_t stays = 0;  ///< of 3 equal readings or more; 0: y is not cut off
  double share = 0;       ///< of the samples, in these stays, 0 … 1
};

/// (E26) Whether y is cut off at its highest or its lowest reading: it repeats that to
/// the last digit, in a fiftieth of the samples or more. Unlike a peak, which leaves a
/// quarter of the samples of any narrow band below its top in the upper sixteenth, a cut
/// leaves nearly all there; unlike a switch, y moves from sample to sample elsewhere.
/// Where noise moves it, so that nothing repeats that only settles, one stay of six
/// readings tells; else three stays do, to which y comes about as fast as it goes.
///
/// What it cannot tell: a cut in a resolution of fewer than some thirty steps, or with
/// noise on top of it. Offset and scale do not matter. Cost: five passes.
[[nodiscard]] RangeEnd find_range_end(std::span<const double> y, bool upper);

}  // namespace ident
