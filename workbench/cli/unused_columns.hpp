// Measured signals of a recording that nobody asked for.
#pragma once

#include <string>
#include <vector>

#include "workbench/cli/model_options.hpp"
#include "workbench/recording/recording.hpp"

namespace workbench::cli {

/// What there is to say about `further`, the signals beside those of the loop: which
/// were not used, the first three by name, and what tries them. Those that never change
/// do not count; "" where none is left.
[[nodiscard]] std::string note_on_unused(const std::vector<Load>& further);

/// Complains with that note about recordings for which no load was asked; they are read
/// once more for it. Nothing where that fails.
void complain_about_unused(ModelOptions options, Column output);

}  // namespace workbench::cli
