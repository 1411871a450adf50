// How much of a recorded signal was really stored.
#pragma once

#include <cstdint>
#include <span>

namespace ident {

/// What stands between the stored points of a signal.
enum class Storage : std::uint8_t {
  kEverySample,   ///< nothing: each sample was stored, or nothing speaks against it
  kInterpolated,  ///< straight lines: compression, as by a swinging door
  kHeld,          ///< the last value: exception reporting, or a slower scan
};

/// Of one signal.
struct StoredSignal {
  Storage storage = Storage::kEverySample;
  double interpolated =
      0;            ///< share of the samples inside straight, sloping lines, 0 … 1
  double held = 0;  ///< share of the samples that repeat the one before, 0 … 1
  double points_apart =
      1;  ///< mean distance of the stored points, samples; 1 if each was
};

/// Samples inside a straight line have no second difference, but for the resolution of
/// the values. Noise makes a run of three such samples about once in 10⁵, so a large
/// share of them was not measured. Held values are told from a coarse resolution by lying
/// anywhere, not a few of the smallest change apart, and from a signal at rest by each
/// change standing alone.
///
/// What it cannot tell: lines so flat, or stored so coarsely, that the resolution hides
/// them; a sensor that sticks from exception reporting (see sensor_hold.hpp); an
/// operator's or a test's many steps of u from either. u runs straight by itself while a
/// controller integrates a constant error: `was_compressed` asks y first. Offset and
/// scale do not matter.
///
/// Cost: three passes.
[[nodiscard]] StoredSignal find_storage(std::span<const double> values);

/// Whether lines between stored points can be believed: of y, or of u where y neither
/// rests nor is too coarse for its noise to show.
[[nodiscard]] bool was_compressed(const StoredSignal& u, const StoredSignal& y);

}  // namespace ident
