// Instants that only the samples around them tell, in stretches that are not fitted.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "workbench/effects/situation.hpp"
#include "workbench/model/base/blocks.hpp"
#include "workbench/model/fit/free_run.hpp"

namespace workbench {

/// A sudden instant (SearchedParameter) that lies between two fitted samples: all places
/// in there fit them alike, or nearly so.
struct SuddenInstant {
  std::size_t slot = 0;  ///< as in FreeRun::slots
  SampleRange stretch;   ///< not fitted; the instant lies within, or at its border
};

/// Those of a point `p` that are searched.
[[nodiscard]] std::vector<SuddenInstant> sudden_instants(
    std::span<const FreeRun::Slot> slots, std::span<const double> p,
    const Situation& situation);

/// What the samples of the stretch, fitted like the others, say of the instant.
struct SuddenPlace {
  std::vector<double> p;  ///< the point with the instant moved, and with the form of its
                          ///< effect (constants of 0 or 1) that goes with it
  double low = 0;         ///< s; all places where the squared error is less than `rise`
  double high = 0;        ///< above its least, whatever the form
};

/// Looks for the instant all over its stretch and two samples to each side of it, to half
/// a sample; where no place is better it stays. The stretch no longer
/// judges the effect. Cost: some 30 runs for each form; with a `rise`, some 50.
[[nodiscard]] SuddenPlace place_of(const SuddenInstant& instant,
                                   const Situation& situation, const Blocks& blocks,
                                   const std::vector<const Effect*>& effects,
                                   std::vector<double> p, const Work& work,
                                   double rise = 0);

}  // namespace workbench
