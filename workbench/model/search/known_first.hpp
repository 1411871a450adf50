// A cause that is known before a load that nobody measured.
#pragma once

#include <vector>

#include "workbench/model/search/trial.hpp"

namespace workbench {

/// `best`, or the accepted trial that is told in its place, with a score that lists it
/// first. Where `best` is a load step alone: the valve that the identification found (a
/// load that steps at will follows one excursion of y better than the valve that made it;
/// one that swings has to do so in every period). Where it holds a load that nobody
/// measured: the same with a recorded load instead, if that leaves less than twice as
/// much of the squared error on the samples that judge. What is left is looked at again
/// when the known cause is in the model.
[[nodiscard]] Trial* known_first(const Fitter& fitter, std::vector<Trial>& trials,
                                 Trial* best);

/// True for a load that steps and nobody measured, by itself.
[[nodiscard]] bool is_lone_load_step(const Trial& trial);

/// True of a ramp or a step of a load that nobody measured, which come when they like.
[[nodiscard]] bool is_slow_load(const Effect& effect);

/// True where `effects` hold a load that nobody measured, and none that was recorded.
[[nodiscard]] bool has_unknown_cause(const std::vector<const Effect*>& effects);

}  // namespace workbench
