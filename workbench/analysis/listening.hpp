// Which oscillation is the largest in a signal, fast or slow.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace workbench {

/// Means of each `count` values, at least 1, one after the other; what is left over at
/// the end is dropped.
[[nodiscard]] std::vector<double> means(std::span<const double> values,
                                        std::size_t count);

struct Heard {
  double period = 0;        ///< samples of the signal; 0: none
  double amplitude = 0;     ///< in units of the signal
  std::size_t thinned = 1;  ///< means of so many samples show it
  /// Of the fastest one that has a quarter of its amplitude, samples; 0: none.
  double fastest = 0;
};

/// The largest oscillation that the detector sees in `signal`, or in its means of 16,
/// 256, … samples as long as 256 of them are left: a detector's ring ends at a period of
/// some hundred samples. One that ended counts if it lasted for a tenth of `signal`; in
/// means eight waves are needed. O(samples).
[[nodiscard]] Heard listen(std::span<const double> signal);

}  // namespace workbench
