// Tells when the stick band of a loop has changed: by more than its intervals allow.
//
// Life: new → take, once for each window that was due. A stroke's band has changed when
// the intervals of two such windows in a row lie on one side of that of the band told
// last and do not touch it; what the second of them says is told next. A window that
// knows no band of a stroke says nothing about it. The first one known is not a change.
// Constant time, no heap.
#pragma once

#include <array>

#include "wire/loop_memory.hpp"

namespace firmware {

class BandWatch {
 public:
  /// Ascending and descending; NaN where it is not known.
  using Bands = std::array<wire::BandInterval, 2>;

  /// True: a band has changed.
  [[nodiscard]] bool take(const Bands& bands);
  /// Told last; what to keep over a restart.
  [[nodiscard]] const Bands& told() const { return told_; }
  void restore(const Bands& told) { told_ = told; }

 private:
  Bands told_ = wire::LoopMemory{}.told_bands;
  std::array<int, 2> aside_{};  // −1 below, 1 above: the window before lay there
};

}  // namespace firmware
