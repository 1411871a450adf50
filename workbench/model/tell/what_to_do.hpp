// What a technician does about what a model lacks.
#pragma once

#include <string>
#include <vector>

#include "workbench/model/search/explain.hpp"

namespace workbench {

/// Whole sentences in plain text: how to tell the candidate from its rivals, where it has
/// any, then a cure for each of its members. That nothing is broken is said only of what
/// the recording tells from every fault. `best`: an accepted candidate with its cures.
/// `valve_in_doubt`: the verdict on the valve finds a fault that the model lacks.
[[nodiscard]] std::vector<std::string> what_to_do(const Candidate& best,
                                                  bool valve_in_doubt);

}  // namespace workbench
