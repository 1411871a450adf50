// A process that answers within the row of the u that moved it.
#pragma once

#include <span>

#include "workbench/recording/recording.hpp"

namespace workbench {

/// (W39) Sign with which y jumps in the rows in which u jumps from or to a rest at an end
/// of its range, and stays: the log wrote y after u had acted. Of the two only u can be
/// switched. 0 where they do not, not always the same way, or one is missing. O(samples).
[[nodiscard]] int sign_of_jumps(std::span<const double> u, std::span<const double> y);

/// (W39) True where y answers in the row of u: it jumps there, or, of a u that is moved
/// out of rest, moves there as it goes on to. O(samples).
[[nodiscard]] bool answers_within_row(std::span<const double> u,
                                      std::span<const double> y);

/// Adds a note where it does: models then take u one row earlier.
void note_within_row(Recording& recording);

}  // namespace workbench
