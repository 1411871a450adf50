// Effects of a model whose addition did not lower the validation error.
#pragma once

#include <string_view>

#include "workbench/model/base/model.hpp"

namespace workbench {

/// The step in which `effect` was last added, where the error on samples that were not
/// fitted rose in it; else null. It belongs to `model`.
[[nodiscard]] const HistoryStep* harm_of(const Model& model, std::string_view effect);

/// Where the error of all samples fell in that step, the effect may still be there; where
/// it rose, too, nothing speaks for it.
[[nodiscard]] bool is_in_doubt(const HistoryStep& harm);

}  // namespace workbench
