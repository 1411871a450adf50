// Whether several recordings are of one loop, each of a time of its own.
#pragma once

#include <string>
#include <vector>

#include "workbench/recording/recording.hpp"

namespace workbench {

/// Throws InputError naming two files whose units of u, y, x or a load differ where both
/// say one, or whose instruments are of two loops (Recording::loop). FIC101 of one file
/// and Area1.FIC101 of another are one.
void check_one_loop(const std::vector<Recording>& recordings);

/// A sentence for each two recordings whose clock times overlap by more than a sample:
/// what both hold would count twice. Nothing is said of recordings that hold the same, of
/// times without a date, or of two of which only one has a zone.
[[nodiscard]] std::vector<std::string> overlaps_of(
    const std::vector<Recording>& recordings);

}  // namespace workbench
