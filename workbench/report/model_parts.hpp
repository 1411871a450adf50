// The words and tables on a model, as HTML, for the report and for the workbench page.
#pragma once

#include <string>

#include "workbench/report/model_figures.hpp"

namespace workbench {

// Each returns HTML.

/// The box of the headline, with evidence, group, cure and the worst place.
[[nodiscard]] std::string model_verdict(const ModelReport& report);
/// Fit, validation error, fall since the start, effects.
[[nodiscard]] std::string model_tiles(const ModelReport& report);
/// The validation error after each step; nothing without history.
[[nodiscard]] std::string step_table(const Model& model);
/// Every candidate with status, evidence and group; what the data neither support nor
/// leave open is behind a click. Each <li> names its effects in data-effects, separated
/// by spaces.
[[nodiscard]] std::string candidate_list(const ExplainResult& result);
/// Parameters with intervals and units, those of the recording where it names them,
/// effect by effect, the process last.
[[nodiscard]] std::string parameter_table(const ModelReport& report);

}  // namespace workbench
