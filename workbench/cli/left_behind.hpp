// Effects of a model that do not go with it to a recording that judges.
#pragma once

#include <string>

#include "workbench/model/base/model.hpp"
#include "workbench/recording/recording.hpp"

namespace workbench::cli {

/// Which effects of `model` belong to the recordings that were fitted (stays_behind(),
/// free_run.hpp) and are left out of those that judge; "" where there is none of either.
[[nodiscard]] std::string note_on_left_behind(const Model& model,
                                              const Recording& recording);

/// Complains with that note.
void complain_about_left_behind(const Model& model, const Recording& recording);

}  // namespace workbench::cli
