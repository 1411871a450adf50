// When a level changed, for good or for a while, whatever u did then.
#pragma once

#include <cstddef>
#include <vector>

#include "workbench/effects/situation.hpp"

namespace workbench {

/// A level that the output has for a while: samples first … last - 1.
struct PassingLevel {
  std::size_t first = 0;
  std::size_t last = 0;
};

struct LevelChanges {
  /// (W13) The sample at which one change of level explains most of what neither the
  /// model so far nor answers of other lags to u explain, on the estimation samples, and
  /// up to two more at least a tenth of the record away; best first. A controller answers
  /// a load, so that a model without it has bent its answer to u.
  std::vector<std::size_t> for_good;
  /// (W28) Up to two passing levels that explain, in the same way, more than any one
  /// change for good, by more than a further change is worth by chance; best first,
  /// neither end of the second near that of the first.
  std::vector<PassingLevel> passing;
};

/// O(samples + pairs of 80 instants).
[[nodiscard]] LevelChanges level_changes(const Situation& situation);

}  // namespace workbench
