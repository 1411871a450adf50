// The contract's JSON of the oscillation detector.
#pragma once

#include <nlohmann/json.hpp>

#include "ident/signal/oscillation_detector.hpp"

namespace workbench {

/// The object of `stickband oscillation --json`. `period_s` is that of the samples;
/// period and amplitude are null where no oscillation is seen.
[[nodiscard]] nlohmann::ordered_json oscillation_json(
    const ident::OscillationReport<double>& report, double period_s);

}  // namespace workbench
