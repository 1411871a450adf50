// The coordinates in which a residual is looked at, sample by sample.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "workbench/effects/effect.hpp"
#include "workbench/effects/situation.hpp"
#include "workbench/model/base/work.hpp"

namespace workbench {

/// Bins of one view: each sample belongs to one, or to none (-1).
struct Binning {
  View view = View::kTime;
  std::string coordinate;        ///< axis label with unit
  std::vector<double> position;  ///< middle of each bin
  std::vector<int> bin;          ///< of each sample
  bool ring = false;             ///< the last bin is next to the first
};

/// Time, phase, level, direction, speed and travel; frequency and lag are not properties
/// of single samples. Phase and travel count from reversals of u by more than a tenth of
/// its span: phase 0 … 1 from one lower reversal to the next, travel positive after a
/// lower reversal, negative after an upper one. O(samples) each. Throws as Work::check().
[[nodiscard]] std::vector<Binning> binnings_of(const Situation& situation,
                                               std::span<const double> t,
                                               const Work& work = Work::unlimited());

/// "u between 40 and 44", "the first 0.6 u after an ascending reversal".
[[nodiscard]] std::string place_in_words(const Binning& binning, std::size_t first,
                                         std::size_t last);

}  // namespace workbench
