// What several windows of one loop say together.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "ident/verdict/identification.hpp"

namespace workbench {

/// Windows of each verdict, by ident::Verdict.
using Votes = std::array<int, 5>;

/// Windows that cannot tell abstain. A fault (stiction or backlash) or its absence stands
/// if more windows say so than the opposite, and at least a quarter of all; the fault is
/// the one that more windows name. Else undecided.
[[nodiscard]] ident::Verdict majority_of(const Votes& votes);

/// " 3 stiction, 1 undecided", in the order of ident::Verdict; "" without windows.
[[nodiscard]] std::string listed(const Votes& votes);

/// Medians of value and ends over those that are known; unknown where none is.
[[nodiscard]] ident::Estimate<double> median_of(
    const std::vector<ident::Estimate<double>>& estimates);

}  // namespace workbench
