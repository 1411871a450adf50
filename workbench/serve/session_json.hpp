// How a session stands, as JSON.
#pragma once

#include <exception>
#include <nlohmann/json.hpp>
#include <string>

#include "workbench/serve/session.hpp"

namespace workbench {

/// {"schema","version","revision","recording","model","explained","can_undo","job",
/// "error"}; null where there is none.
[[nodiscard]] nlohmann::ordered_json state_json(const Session& session);

/// {"name","samples","sample_period_s","columns","notes"}.
[[nodiscard]] nlohmann::ordered_json recording_json(const Recording& recording);

/// {"kind","message"}, and for bad input "file","line","column","expected","found",
/// "advice".
[[nodiscard]] nlohmann::ordered_json error_json(const std::exception_ptr& error);

/// Longest signals that are sent as they are; longer ones are thinned so that every peak
/// stays.
inline constexpr std::size_t kMostDrawnSamples = 100'000;

/// One JSON object of arrays: t, u, measured, and where there are any sp, simulated and
/// residual; "samples" before thinning. Seven digits, time fifteen. As text, for it is
/// long.
[[nodiscard]] std::string signals_json(const SessionView& view);

}  // namespace workbench
