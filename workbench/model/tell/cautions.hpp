// What to know about a model before its numbers are used.
#pragma once

#include <string>
#include <vector>

#include "workbench/model/base/model.hpp"

namespace workbench {

/// Whole sentences in plain text, empty where there is nothing to say: a first lag that
/// only the length of the recording bounds, a fit that a constant would reach, too.
/// `fit_percent`: that of the model on the recording, contract's fit.
[[nodiscard]] std::vector<std::string> cautions(const Model& model, double fit_percent);

}  // namespace workbench
