// Requests that make, judge and change models.
#include <algorithm>

#include "workbench/model/tell/explanation_json.hpp"
#include "workbench/model/tell/model_json.hpp"
#include "workbench/recording/parsed_json.hpp"
#include "workbench/recording/text_file.hpp"
#include "workbench/serve/api_handlers.hpp"
#include "workbench/serve/api_request.hpp"
#include "workbench/serve/session_json.hpp"

namespace workbench {
namespace {

using Json = nlohmann::ordered_json;

// {"output","with"}, or nothing, asks for a new start; all else must be a model file.
bool asks_for_a_start(const ApiRequest& request) {
  if (request.query.contains("name")) return false;
  if (request.body.empty()) return true;
  const Json json = parsed_json<Json>(request.body);
  return json.is_object() &&
         std::all_of(json.items().begin(), json.items().end(), [](const auto& item) {
           return item.key() == "output" || item.key() == "with";
         });
}

}  // namespace

const ExplainResult& explanation_in(const SessionView& view) {
  const ModelStep& step = view.last();
  if (!step.explanation) {
    throw NotNow("this model has not been explained yet; POST /api/explain first");
  }
  return *step.explanation;
}

ApiResponse post_model(Session& session, const ApiRequest& request) {
  if (!asks_for_a_start(request)) {
    session.take(
        parse_model(request.body, file_name(value_or(request, "name", "model.json"))));
    return json_response(state_json(session));
  }
  const Json wish = object_in(request);
  const Json output = wish.value("output", Json("y"));
  session.start(
      output_named(output.is_string() ? output.get<std::string>() : output.dump()),
      codes_in(wish, "with"));
  return accepted(session);
}

ApiResponse get_compare(Session& session, const ApiRequest&) {
  return json_response(comparison_json(session.view().last().comparison));
}

ApiResponse post_explain(Session& session, const ApiRequest& request) {
  session.explain(value_or(request, "unasked", "") == "1" ? Asked::no : Asked::yes);
  return accepted(session);
}

ApiResponse get_explain(Session& session, const ApiRequest&) {
  return json_response(explanation_json(explanation_in(session.view())));
}

ApiResponse post_add(Session& session, const ApiRequest& request) {
  session.add(effects_in(request));
  return accepted(session);
}

ApiResponse get_add(Session& session, const ApiRequest&) {
  const SessionView view = session.view();
  const Model& model = view.last().model;
  if (model.history.empty() || !model.has(model.history.back().effect)) {
    throw NotNow("nothing was added to this model last; POST /api/add first");
  }
  return json_response(added_json(model));
}

ApiResponse post_remove(Session& session, const ApiRequest& request) {
  session.remove(effects_in(request).front());
  return accepted(session);
}

ApiResponse get_ladder(Session& session, const ApiRequest&) {
  const SessionView view = session.view();
  if (!view.last().ladder) {
    throw NotNow("this model was not made by the ladder; POST /api/ladder first");
  }
  return json_response(ladder_json(*view.last().ladder));
}

}  // namespace workbench
