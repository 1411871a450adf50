#include "workbench/serve/api.hpp"

#include <algorithm>
#include <array>

#include "workbench/recording/filled.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/listed.hpp"
#include "workbench/serve/api_handlers.hpp"
#include "workbench/serve/api_request.hpp"
#include "workbench/serve/session_json.hpp"

namespace workbench {
namespace {

ApiResponse get_state(Session& session, const ApiRequest&) {
  return json_response(state_json(session));
}

// Asks something of the session; what became of it is the answer.
template <void (Session::*kAsk)(), int kStatus = 200>
ApiResponse ask(Session& session, const ApiRequest&) {
  (session.*kAsk)();
  return json_response(state_json(session), kStatus);
}

struct Route {
  const char* path;
  ApiHandler* get;
  ApiHandler* post;
};
constexpr std::array kRoutes = {
    Route{"/api/state", get_state, nullptr},
    Route{"/api/effects", get_effects, nullptr},
    Route{"/api/recording", get_recording, open_recording},
    Route{"/api/columns", nullptr, post_columns},
    Route{"/api/table", nullptr, post_table},
    Route{"/api/example", nullptr, open_example},
    Route{"/api/direction", nullptr, post_direction},
    Route{"/api/signals", get_signals, nullptr},
    Route{"/api/valve", get_valve, nullptr},
    Route{"/api/model", get_model, post_model},
    Route{"/api/compare", get_compare, nullptr},
    Route{"/api/explain", get_explain, post_explain},
    Route{"/api/add", get_add, post_add},
    Route{"/api/remove", nullptr, post_remove},
    Route{"/api/ladder", get_ladder, ask<&Session::climb, 202>},
    Route{"/api/undo", nullptr, ask<&Session::undo>},
    Route{"/api/redo", nullptr, ask<&Session::redo>},
    Route{"/api/cancel", nullptr, ask<&Session::cancel>},
    Route{"/api/try", nullptr, post_try},
    Route{"/api/range", nullptr, post_range},
    Route{"/api/leave_out", nullptr, post_leave_out},
    Route{"/api/split", nullptr, post_split},
    Route{"/api/preview", get_preview, post_preview},
    Route{"/api/beside", get_beside, post_beside},
    Route{"/api/dismiss", nullptr, post_dismiss},
    Route{"/api/together", nullptr, post_together},
    Route{"/api/models", get_models, nullptr},
    Route{"/api/simulated", get_simulated, nullptr},
    Route{"/api/session", get_session, post_session},
    Route{"/api/csv", get_csv, nullptr},
    Route{"/api/commands", get_commands, nullptr},
    Route{"/api/parts", get_parts, nullptr},
    Route{"/api/report", get_report, nullptr},
};

// What is asked for is not the recording that is open.
class OtherOpen : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A page names the recording that it shows: ?opening=, as in /api/state.
void check_opening(const Session& session, const ApiRequest& request) {
  if (value_or(request, "opening", "").empty()) return;
  const std::uint64_t wanted = count_in(request, "opening", "the number of an opening");
  const SessionView view = session.view();
  if (wanted == view.opening) return;
  if (wanted < session.begun() || view.recording == nullptr) {
    throw OtherOpen(
        "the program was started anew and does not know the recording that this page "
        "shows; open it again, or reload the page");
  }
  throw OtherOpen(
      filled("another recording is open now, in another tab or window: {0}; reload the "
             "page to see it, or open yours again",
             {workbench::quoted(view.recording->name)}));
}

ApiResponse routed(Session& session, const ApiRequest& request) {
  const auto route = std::ranges::find_if(
      kRoutes, [&](const Route& r) { return request.path == r.path; });
  if (route == kRoutes.end()) {
    return error_response(404, "no address " + workbench::quoted(request.path) +
                                   "; known: " + listed(kRoutes, ", ", &Route::path));
  }
  const auto handler = request.method == "GET"    ? route->get
                       : request.method == "POST" ? route->post
                                                  : nullptr;
  if (handler == nullptr) {
    return error_response(405, std::string(route->path) + " takes " +
                                   (route->get == nullptr    ? "POST"
                                    : route->post == nullptr ? "GET"
                                                             : "GET and POST") +
                                   ", found " + workbench::quoted(request.method));
  }
  check_opening(session, request);
  session.await(turn_in(request));
  return handler(session, request);
}

}  // namespace

ApiResponse error_response(int status, const std::string& message) {
  return error_of(status, {{"message", message}});
}

ApiResponse answer(Session& session, const ApiRequest& request) {
  try {
    return routed(session, request);
  } catch (const OtherOpen& error) {
    return error_of(409, {{"kind", "other_open"}, {"message", error.what()}});
  } catch (const NotNow& error) {
    return error_response(409, error.what());
  } catch (const BadRequest& error) {
    return error_response(400, error.what());
  } catch (const InputError&) {
    return error_of(400, error_json(std::current_exception()));
  } catch (const std::invalid_argument& error) {
    return error_response(400, error.what());
  } catch (const std::exception& error) {
    return error_response(500, error.what());
  }
}

}  // namespace workbench
