// Samples at common instants from signals that arrive each at its own rate.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workbench/recording/can/can_series.hpp"
#include "workbench/recording/recording.hpp"

namespace workbench {

/// Zero-order hold at instants as read_candump() says, into the columns of `out`, its
/// period and its report. Throws InputError; `name` stands in messages.
void sample_series(const std::vector<CanSeries>& series, const std::string& name,
                   std::optional<double> period_s, Recording& out);

}  // namespace workbench
