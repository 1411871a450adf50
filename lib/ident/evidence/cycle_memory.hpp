// Whether y is foretold by what happened one cycle ago: a load from outside that comes
// back by a clock of its own.
#pragma once

#include <array>
#include <cstddef>

#include "ident/evidence/lag_bins.hpp"
#include "ident/evidence/stem_passes.hpp"

namespace ident {

/// (E15) Nats by which predicting y one sample ahead (E10) is better with the lags of u
/// and y about one cycle ago than without. A valve that sticks is where it is by what u
/// did last, and keeps no clock; a neighbour's limit cycle, a batch or a pump that cuts
/// in come at their own time, whatever this loop does meanwhile.
///
/// Life: `start`, then `step` until it says true. Cost: a pass of 12 bins and one of 19,
/// one more for each lag within a tenth of the period; some kUnit thousand instructions a
/// piece.
template <class Real>
class CycleMemory {
 public:
  /// `period` of the window is that of an oscillation, samples.
  void start(const EvidenceWindow<Real>& window);
  /// Some pieces, `budget` units; true when done.
  bool step(int budget);
  /// When done; 0 where the window has no three cycles, or they are shorter than what the
  /// nearest lags know in detail.
  [[nodiscard]] Real nats() const { return nats_; }

 private:
  static constexpr std::size_t kAround = 3;  // bins on either side of a cycle
  static constexpr std::size_t kLags = kCoarseLagBins.size() + 2 * kAround + 1;

  int weigh_lag();
  void begin_without();
  void take_error();

  StemPasses<Real> passes_;
  std::array<LagBin, kLags> bins_;
  std::size_t bases_ = 0;  // of them, without a cycle's
  std::size_t lag_ = 0;
  std::size_t last_lag_ = 0;
  std::size_t cycle_ = 0;  // the lag at which y is most like itself
  Real most_alike_ = 0;
  std::size_t first_ = 0;  // predicted sample
  Real log_without_ = 0;
  Real nats_ = 0;
  bool remembers_ = false;
  bool done_ = true;
};

}  // namespace ident
