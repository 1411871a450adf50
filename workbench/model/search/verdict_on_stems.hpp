// What the identification of the valve says of the stems that a model may gain from.
#pragma once

#include <optional>
#include <vector>

#include "workbench/model/fit/fit.hpp"
#include "workbench/model/search/identified.hpp"
#include "workbench/model/search/trial.hpp"

namespace workbench {

/// (W12) A stem fitted running free takes up what a load or a missing linear part leaves
/// over, and drowns in what a load adds. One sample ahead both are known from the past of
/// y. So where the identification finds no fault, has nothing for its own stem, and says
/// how small a stick band would have shown, a wider one is none; where it is undecided,
/// and its own stem foretells nothing, or the setpoint explains the movement and no stem
/// is closer, another one is none, too; and where it finds a fault by more than it needs
/// alone, a stem of that width is there; and a load that steps and nobody measured does
/// not come before a stem that the identification finds, too. Asks the identification
/// only where that may change an answer.
class VerdictOnStems {
 public:
  /// Both must outlive this.
  VerdictOnStems(const Fitter& fitter, Identified& identified)
      : fitter_(&fitter), identified_(&identified) {}

  /// The smallest stick band, units of u, that would have shown and did not; nothing
  /// where none is known. Throws as Identified::result().
  [[nodiscard]] std::optional<double> excluded_from() const;
  /// Leaves an accepted trial undecided whose stem the identification speaks against,
  /// unless it foretells y beyond doubt beside the two that come with it, which the
  /// identification does not have. Where the trial has loads, the identification has to
  /// say so of the output less those, too.
  void refute(Trial& trial) const;
  /// Accepts the trial of the stem that the identification found, where none of `trials`
  /// has a stem that is accepted: its error is smaller, its parameters exclude "off", and
  /// its stick band is that of the identification within a factor of two.
  void confirm(std::vector<Trial>& trials) const;
  /// Marks the accepted trials of one stem as identified where the identification finds a
  /// fault of that stick band, within a factor of two, and one of `trials` is a load that
  /// steps and nobody measured.
  void mark(std::vector<Trial>& trials) const;
  /// Lists stiction beside a `best` with play where the identification finds a slip jump
  /// that is not 0, of a stem as wide: running free one slip that is missed leads a stem
  /// astray for long, so that one that does not slip may leave less.
  void name_slip(std::vector<Trial>& trials, Trial& best) const;

 private:
  [[nodiscard]] Identification less_loads(const Fit& fit) const;

  const Fitter* fitter_;
  Identified* identified_;
};

}  // namespace workbench
