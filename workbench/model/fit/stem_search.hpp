// Sticking stems that the identification sees in a recording: starts for a fit.
#pragma once

#include <span>
#include <vector>

#include "workbench/effects/situation.hpp"
#include "workbench/model/base/work.hpp"

namespace workbench {

/// (W5) The valve that the identification (ident/identifier.hpp) chooses for u and y, of
/// equal length; empty where it sees none that sticks. Looks at the first 4,096 samples,
/// and where `later_cycles` at later cycles of them, too, where the first lead nowhere
/// (T9). Cost: about 0.2 s for 2,000 samples, half as much again with later cycles.
[[nodiscard]] std::vector<SeenStem> stems_seen(std::span<const double> u,
                                               std::span<const double> y, double period_s,
                                               bool later_cycles = true,
                                               const Work& work = Work::unlimited());

}  // namespace workbench
