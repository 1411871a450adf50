// The state of a model in one sentence.
#pragma once

#include <string>

#include "workbench/report/model_figures.hpp"

namespace workbench {

/// What is missing, what was found, or that the data do not tell. Plain text.
[[nodiscard]] std::string model_headline(const ModelReport& report);

}  // namespace workbench
