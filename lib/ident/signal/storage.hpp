// How much of a recorded signal was really stored.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "ident/signal/differences.hpp"

namespace ident {

/// What stands between the stored points of a signal.
enum class Storage : std::uint8_t {
  kEverySample,   ///< nothing: each sample was stored, or nothing speaks against it
  kInterpolated,  ///< straight lines: compression, as by a swinging door
  kHeld,          ///< the last value: exception reporting, or a slower scan
};

/// Of one signal.
template <class Real>
struct StoredSignal {
  Storage storage = Storage::kEverySample;
  Real interpolated = 0;  ///< share of the samples inside straight, sloping lines, 0 … 1
  Real held = 0;          ///< share of the samples that repeat the one before, 0 … 1
  Real points_apart = 1;  ///< mean distance of the stored points, samples; 1 if each was
};

/// Samples inside a straight line have no second difference, but for the resolution of
/// the values. Noise makes a run of three such samples about once in 10⁵, so a large
/// share of them was not measured. Held values are told from a coarse resolution by lying
/// anywhere, not whole multiples of the smallest change apart, and from a signal at rest
/// by each change standing alone.
///
/// What it cannot tell: lines so flat, or stored so coarsely, that the resolution hides
/// them; a sensor that sticks from exception reporting (see sensor_hold.hpp); an
/// operator's or a test's many steps of u from either. u runs straight by itself while a
/// controller integrates a constant error: `was_compressed` asks y first. Offset and
/// scale do not matter.
///
/// Life: start → step until true → signal. Cost: two passes.
template <class Real>
class StorageSearch {
 public:
  /// The span must outlive the work.
  void start(std::span<const Real> values);
  /// One pass; true when done.
  bool step();
  [[nodiscard]] const StoredSignal<Real>& signal() const { return signal_; }

 private:
  enum class Stage : std::uint8_t { kDifferences, kPieces, kDone };

  void count_pieces();

  std::span<const Real> values_;
  StoredSignal<Real> signal_;
  Differences<Real> differences_;
  Stage stage_ = Stage::kDone;
};

/// The same, all at once.
template <class Real>
[[nodiscard]] StoredSignal<Real> find_storage(std::span<const Real> values);

/// Whether lines between stored points can be believed: of y, or of u where y neither
/// rests nor is too coarse for its noise to show.
template <class Real>
[[nodiscard]] bool was_compressed(const StoredSignal<Real>& u,
                                  const StoredSignal<Real>& y);

}  // namespace ident
