// One function for each request of the API; api.hpp has the table.
#pragma once

#include "workbench/serve/api.hpp"

namespace workbench {

/// Of the last model. Throws NotNow before it was explained.
[[nodiscard]] const ExplainResult& explanation_in(const SessionView& view);

/// A file name without its last extension.
[[nodiscard]] std::string stem_of(const std::string& name);

// Throw NotNow, BadRequest (api_request.hpp), InputError and std::invalid_argument.
[[nodiscard]] ApiResponse get_add(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse get_beside(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse get_commands(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse get_compare(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse get_csv(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse get_effects(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse get_explain(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse get_ladder(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse get_model(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse get_models(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse get_parts(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse get_preview(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse get_recording(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse get_report(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse get_session(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse get_signals(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse get_simulated(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse get_state(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse get_valve(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse open_example(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse open_recording(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse post_add(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse post_remove(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse post_beside(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse post_cancel(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse post_table(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse post_columns(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse post_direction(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse post_dismiss(Session& session, const ApiRequest& request);
ApiResponse post_together(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse post_explain(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse post_ladder(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse post_leave_out(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse post_model(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse post_preview(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse post_range(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse post_redo(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse post_session(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse post_split(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse post_try(Session& session, const ApiRequest& request);
[[nodiscard]] ApiResponse post_undo(Session& session, const ApiRequest& request);

}  // namespace workbench
