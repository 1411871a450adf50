// The steps of a ladder for a terminal of 80 columns.
#pragma once

#include <string>
#include <vector>

#include "workbench/model/search/ladder.hpp"

namespace workbench::cli {

/// A row for each step: its name, the error, the validation error and how that fell;
/// below it what it may as well be. An exchange is one row, whatever the errors on the
/// way; what came and went without lowering the error is a line without any, told once.
/// The first row names the effects that the ladder began with.
[[nodiscard]] std::string steps_text(const std::vector<LadderStep>& steps,
                                     const std::vector<std::string>& begun_with = {});

}  // namespace workbench::cli
