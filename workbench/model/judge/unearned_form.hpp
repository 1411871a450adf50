// A form of an effect that explains no more than the plain one.
#pragma once

#include "workbench/model/fit/fit.hpp"

namespace workbench {

/// `fit`, or the same without the optional form of one of its effects (a dead time that
/// follows the flow), searched on from there, where that form does not lower the error as
/// another effect has to (merit.hpp) or, unless u moves by hand, is not seen one sample
/// ahead: (W29). A load keeps its form: when it comes and goes is looked for together.
/// Cost: a search for each form.
[[nodiscard]] Fit without_unearned_forms(const Fitter& fitter, Fit fit);

}  // namespace workbench
