// What several windows of one loop say together.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "ident/verdict/identification.hpp"

namespace workbench {

/// Of each verdict, by ident::Verdict, the weight of the windows that say so: their
/// lengths, in any unit.
using Votes = std::array<double, 5>;
/// The same, how many they are.
using VoteCounts = std::array<int, 5>;

/// Windows that cannot tell abstain. A fault (stiction or backlash) or its absence stands
/// if more of the time says so than the opposite: for a fault at least a quarter of all,
/// which is the one that more of it names, for its absence half of all. Else undecided.
[[nodiscard]] ident::Verdict majority_of(const Votes& votes);

/// " 3 stiction, 1 undecided", in the order of ident::Verdict; "" without windows.
[[nodiscard]] std::string listed(const VoteCounts& votes);

/// Medians of value and ends over those that are known; unknown where none is.
[[nodiscard]] ident::Estimate<double> median_of(
    const std::vector<ident::Estimate<double>>& estimates);

}  // namespace workbench
