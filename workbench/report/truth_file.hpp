// What is known to be true about a simulated recording, read back for comparison.
#pragma once

#include <optional>
#include <string>

#include "workbench/simulate/process.hpp"

namespace workbench {

/// The truth, as far as a report shows it.
struct KnownTruth {
  std::string kind;  ///< stiction, backlash or no_stiction
  double stick_band_ascending = 0;
  double stick_band_descending = 0;
  double slip_jump_ascending = 0;
  double slip_jump_descending = 0;
  std::optional<ProcessModel> process;
};

/// Reads the JSON file that `stickband simulate --truth` writes. Throws InputError.
[[nodiscard]] KnownTruth read_truth(const std::string& path);

}  // namespace workbench
