// Three effects at once, for loops that lack three of which no two show without the
// third.
#pragma once

#include <vector>

#include "workbench/model/search/trial.hpp"

namespace workbench {

/// The closest of `pairs`, which have fits, with the third of the effects of `trials`
/// that leaves least. Asked where a pair explains most of what `base` leaves and yet not
/// down to noise; none otherwise. Kept only where each of the three is needed, possible,
/// told from none and, if no linear process does as much, seen one sample ahead beside
/// the other two. Every third that was tried counts in the p-value. Cost: a screening of
/// each effect beside two pairs, and one thorough search.
[[nodiscard]] std::vector<Trial> triples_of(const Fitter& fitter, const Fit& base,
                                            const std::vector<Trial>& trials,
                                            std::vector<Trial> pairs);

/// The trial of two or three members, in the order in which they are told.
[[nodiscard]] Trial in_told_order(std::vector<const Effect*> members, Fit fit);

/// Whether each member of `trial` is possible, told from none and needed by the others
/// and, if no linear process does as much, seen one sample ahead beside them. The trial
/// is then as likely by chance as the weakest of them.
[[nodiscard]] bool each_is_needed(const Fitter& fitter, Trial& trial);

}  // namespace workbench
