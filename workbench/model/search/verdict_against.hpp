// What the identification of the valve says against a stem that a model gains from.
#pragma once

#include <optional>

#include "workbench/model/fit/fit.hpp"
#include "workbench/model/search/trial.hpp"

namespace workbench {

/// (W12) A stem fitted running free takes up what a load or a missing linear part leaves
/// over. One sample ahead neither has a use for it. So where the identification finds no
/// fault, has nothing for its own stem, and says how small a stick band would have shown,
/// a wider one is none. Identifies when first asked.
class VerdictAgainst {
 public:
  /// `fitter` must outlive this.
  explicit VerdictAgainst(const Fitter& fitter) : fitter_(&fitter) {}

  /// The smallest stick band, units of u, that would have shown and did not; nothing
  /// where none is known. Cost of the first call: an identification without two-path
  /// models.
  [[nodiscard]] std::optional<double> excluded_from();
  /// Leaves an accepted trial undecided whose stem has such a band.
  void refute(Trial& trial);

 private:
  const Fitter* fitter_;
  bool asked_ = false;
  std::optional<double> excluded_;
};

}  // namespace workbench
