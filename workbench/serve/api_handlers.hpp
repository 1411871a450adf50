// One function for each request of the API; api.hpp has the table.
#pragma once

#include "workbench/serve/api.hpp"

namespace workbench {

/// Of the last model. Throws NotNow before it was explained.
[[nodiscard]] const ExplainResult& explanation_in(const SessionView& view);

/// A file name without its last extension.
[[nodiscard]] std::string stem_of(const std::string& name);

// Throw NotNow, BadRequest (api_request.hpp), InputError and std::invalid_argument.
using ApiHandler = ApiResponse(Session& session, const ApiRequest& request);
[[nodiscard]] ApiHandler get_add, get_beside, get_commands, get_compare, get_csv,
    get_effects, get_explain, get_ladder, get_model, get_models, get_parts, get_preview,
    get_recording, get_report, get_session, get_signals, get_simulated, get_valve,
    open_example, open_recording, post_add, post_remove, post_beside, post_table,
    post_columns, post_direction, post_dismiss, post_together, post_explain,
    post_leave_out, post_model, post_preview, post_range, post_session, post_split,
    post_try;

}  // namespace workbench
