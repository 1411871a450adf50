// What the identification of the valve says against a stem that a model gains from.
#pragma once

#include <optional>

#include "workbench/model/fit/fit.hpp"
#include "workbench/model/search/identified.hpp"
#include "workbench/model/search/trial.hpp"

namespace workbench {

/// (W12) A stem fitted running free takes up what a load or a missing linear part leaves
/// over. One sample ahead neither has a use for it. So where the identification finds no
/// fault, has nothing for its own stem, and says how small a stick band would have shown,
/// a wider one is none. Asks the identification only where a stem is accepted.
class VerdictAgainst {
 public:
  /// Both must outlive this.
  VerdictAgainst(const Fitter& fitter, Identified& identified)
      : fitter_(&fitter), identified_(&identified) {}

  /// The smallest stick band, units of u, that would have shown and did not; nothing
  /// where none is known. Throws as Identified::result().
  [[nodiscard]] std::optional<double> excluded_from() const;
  /// Leaves an accepted trial undecided whose stem has such a band.
  void refute(Trial& trial) const;

 private:
  const Fitter* fitter_;
  Identified* identified_;
};

}  // namespace workbench
