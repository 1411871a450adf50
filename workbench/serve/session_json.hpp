// How a session stands, as JSON.
#pragma once

#include <exception>
#include <nlohmann/json.hpp>
#include <string>

#include "workbench/serve/session.hpp"

namespace workbench {

/// {"schema","version","revision","drawn","opened","opening","begun","is_range",
/// "left_out","split","recording","verdict","verdict_so_far","verdict_job",
/// "verdict_error","model","explained","opens" ("yes", "no", ""),"stopped","preview",
/// "beside_own","beside","beside_fitted","can_undo","can_redo","job","error"};
/// null where there is none. "model" has "fitted_here" and "belongs_elsewhere", "split"
/// the share that is fitted and the length of a pair of blocks in s (0: as long as the
/// output asks for).
[[nodiscard]] nlohmann::ordered_json state_json(const Session& session);

/// {"name","samples","sample_period_s","from_s","start","columns","tags","units","notes"}.
[[nodiscard]] nlohmann::ordered_json recording_json(const Recording& recording);

/// A model as in its file, less what belongs to the recording, with its errors; units in
/// those of `recording`.
[[nodiscard]] nlohmann::ordered_json quality_json(const ModelStep& step,
                                                  const Recording& recording);

/// "yes", "no", "".
[[nodiscard]] const char* word_of(Opens opens);

/// {"kind","message"}, and for bad input "file","line","column","expected","found",
/// "advice".
[[nodiscard]] nlohmann::ordered_json error_json(const std::exception_ptr& error);

/// True where a model that was fitted to another recording says less about this one than
/// the mean of its output does: it belongs to another loop, or to other units.
[[nodiscard]] bool belongs_elsewhere(const ModelStep& step);

/// Longest signals that are sent as they are; longer ones are thinned so that every peak
/// stays.
inline constexpr std::size_t kMostDrawnSamples = 100'000;

/// One JSON object of arrays: t, u, measured, and where there are any sp, simulated and
/// residual; "samples" before thinning; "blocks" [from, to, 1 where fitted], and "marks"
/// [from, to, kind] (marks.hpp), and "left_out" [from, to], in s; "pieces" [from, to,
/// file, begin in that file] where recordings are joined. Seven digits, time fifteen. As
/// text, for it is long.
[[nodiscard]] std::string signals_json(const SessionView& view);

/// {"simulated":[…]} of a model, at the samples of signals_json().
[[nodiscard]] std::string simulated_json(const SessionView& view, const ModelStep& step);

}  // namespace workbench
