// Loads of real plants: what moved recorded loops whose valve does not stick.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "workbench/simulate/random.hpp"

namespace workbench::test {

/// A recorded signal; its units do not matter.
struct RealLoad {
  std::string name;  ///< folder and file name without ending
  std::string loop;  ///< the loop it was recorded from; several recordings may share it
  std::vector<double> values;
};

/// Every signal of the external recordings that may stand for a load: y of loops that do
/// not stick by their label or whose comment names another cause, and u of loops that are
/// labelled as not oscillating unless they are known to stick. Sorted by name. Empty
/// where the recordings are absent.
[[nodiscard]] std::vector<RealLoad> read_real_loads(const std::filesystem::path& folder);

/// `samples` samples cut out of a load at a random place, without their straight line and
/// with standard deviation 1. One recorded sample lasts `stretch` samples: straight lines
/// between them above 1, means below. A load that is too short is continued backwards
/// from its ends. Empty where the stretch does not move.
[[nodiscard]] std::vector<double> cut_load(Random& random, const RealLoad& load,
                                           std::size_t samples, double stretch);

}  // namespace workbench::test
