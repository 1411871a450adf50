#include "firmware/band_watch.hpp"

#include <cmath>

namespace firmware {

bool BandWatch::take(const Bands& bands) {
  bool changed = false;
  for (std::size_t stroke = 0; stroke < bands.size(); ++stroke) {
    const auto [low, high] = bands[stroke];
    if (std::isnan(low) || std::isnan(high)) continue;
    wire::BandInterval& told = told_[stroke];
    const int side = low > told[1] ? 1 : high < told[0] ? -1 : 0;
    const bool stands = side != 0 && aside_[stroke] == side;
    if (std::isnan(told[0]) || stands) told = bands[stroke];
    aside_[stroke] = stands ? 0 : side;
    changed = changed || stands;
  }
  return changed;
}

}  // namespace firmware
