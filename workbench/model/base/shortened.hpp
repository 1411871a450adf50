// A long recording in few samples, for searches that simulate it thousands of times.
#pragma once

#include <cstddef>
#include <vector>

#include "workbench/recording/recording.hpp"

namespace workbench {

/// What stands for a long recording, and where in it that lies.
struct Shortened {
  Recording recording;
  std::size_t count = 1;    ///< samples that became one (thinned.hpp)
  bool is_excerpt = false;  ///< of each piece only the stretch where u moves most
  /// By how much later the first sample of each piece, or of the recording without
  /// pieces, is in the whole one, s; times count on from the first sample of the first.
  std::vector<double> later_s;

  /// The same instant in the whole recording.
  [[nodiscard]] double in_whole(double seconds) const;
  /// The same instant of the whole recording in this one, or the nearest that it has.
  [[nodiscard]] double in_short(double seconds) const;
};

/// True where shortened() changes anything.
[[nodiscard]] bool is_long(const Recording& recording);

/// (W17) Samples are taken together as far as u and `output` rest within them, up to a
/// hundredth of their variance: a lag, a dead time or a stem that is over within one
/// sample cannot be told. What is long nevertheless is cut to the stretch where u moves
/// most; each piece keeps its share.
[[nodiscard]] Shortened shortened(const Recording& recording, Column output);

}  // namespace workbench
