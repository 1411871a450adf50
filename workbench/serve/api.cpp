#include "workbench/serve/api.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <vector>

#include "workbench/effects/catalogue.hpp"
#include "workbench/model/explanation_json.hpp"
#include "workbench/model/model_json.hpp"
#include "workbench/recording/csv.hpp"
#include "workbench/recording/text_file.hpp"
#include "workbench/report/model_page.hpp"
#include "workbench/report/model_parts.hpp"
#include "workbench/serve/session_json.hpp"
#include "workbench/simulate/recording_csv.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace workbench {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kExampleScenario = "stiction-setpoint";
constexpr std::uint64_t kExampleSeed = 2;

// A request that says something impossible; becomes 400.
class BadRequest : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

ApiResponse json_response(const Json& json, int status = 200) {
  // What is not UTF-8 in a name or message is replaced, not refused.
  return {status,
          "application/json",
          json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n',
          {}};
}

ApiResponse error_of(int status, const Json& error) {
  return json_response({{"schema", 1}, {"error", error}}, status);
}

ApiResponse accepted(const Session& session) {
  return json_response(state_json(session), 202);
}

std::string stem_of(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos || dot == 0 ? name : name.substr(0, dot);
}

std::string value_or(const ApiRequest& request, const char* key, const char* otherwise) {
  const auto found = request.query.find(key);
  return found == request.query.end() || found->second.empty() ? otherwise
                                                               : found->second;
}

Column output_named(const std::string& name) {
  if (name == "y") return Column::y;
  if (name == "x") return Column::x;
  throw BadRequest("expected output y or x, found '" + name + "'");
}

std::optional<double> period_of(const ApiRequest& request) {
  const std::string text = value_or(request, "ts", "");
  if (text.empty()) return std::nullopt;
  double value = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value) ||
      value <= 0) {
    throw BadRequest("expected a positive number of seconds as ts, found " +
                     workbench::quoted(text));
  }
  return value;
}

// Columns or tags by name: ?u=FIC101.OP&y=FIC101.PV&time=...
ColumnNames names_in(const ApiRequest& request) {
  return {value_or(request, "time", ""), value_or(request, "u", ""),
          value_or(request, "y", ""),    value_or(request, "sp", ""),
          value_or(request, "x", ""),    {}};
}

std::optional<DateOrder> date_order_of(const ApiRequest& request) {
  const std::string text = value_or(request, "date_order", "");
  if (text.empty()) return std::nullopt;
  if (text == "dmy") return DateOrder::dmy;
  if (text == "mdy") return DateOrder::mdy;
  if (text == "ymd") return DateOrder::ymd;
  throw BadRequest("expected date_order dmy, mdy or ymd, found " +
                   workbench::quoted(text));
}

Json object_in(const ApiRequest& request) {
  if (request.body.empty()) return Json::object();
  const Json json = Json::parse(request.body, nullptr, false);
  if (!json.is_object()) {
    throw BadRequest("expected a JSON object as body, found " +
                     workbench::quoted(request.body));
  }
  return json;
}

std::vector<std::string> codes_in(const Json& json, const char* key) {
  std::vector<std::string> codes;
  const Json list = json.value(key, Json::array());
  const bool strings =
      list.is_array() && std::all_of(list.begin(), list.end(),
                                     [](const Json& item) { return item.is_string(); });
  if (!strings) {
    throw BadRequest(std::string("expected an array of effects at '") + key + '\'');
  }
  for (const Json& item : list) codes.push_back(item.get<std::string>());
  return codes;
}

ModelReport report_on(const SessionView& view) {
  const ModelStep& step = view.last();
  return {view.opened(), step.model, step.comparison,
          step.explanation.value_or(ExplainResult{})};
}

const ExplainResult& explanation_in(const SessionView& view) {
  const ModelStep& step = view.last();
  if (!step.explanation) {
    throw NotNow("this model has not been explained yet; POST /api/explain first");
  }
  return *step.explanation;
}

ApiResponse open_text(Session& session, const std::string& text, const std::string& name,
                      const ApiRequest& request) {
  const bool keep = !value_or(request, "keep", "").empty();
  CsvOptions options{
      period_of(request), {Column::u}, names_in(request), date_order_of(request)};
  const std::string wanted = value_or(request, "output", "");
  if (!text.empty() && text.find('(') == text.find_first_not_of(" \t\r\n")) {
    throw InputError(name, 1, 1, "a CSV file", "what looks like a candump log",
                     "start `stickband serve` with the log and --dbc");
  }
  Recording recording = parse_csv(text, name, options);
  Column output =
      recording.has(Column::y) || !recording.has(Column::x) ? Column::y : Column::x;
  if (keep) {
    output = session.view().last().model.output;
  } else if (!wanted.empty()) {
    output = output_named(wanted);
  }
  if (!recording.has(output)) {
    options.required = {Column::u, output};
    recording = parse_csv(text, name, options);
  }
  recording.name = name;
  if (keep) {
    session.judge(std::move(recording));
  } else {
    session.open(std::move(recording), output);
  }
  return accepted(session);
}

ApiResponse open_recording(Session& session, const ApiRequest& request) {
  const std::string name = file_name(value_or(request, "name", "recording.csv"));
  return open_text(session, request.body, name.empty() ? "recording.csv" : name, request);
}

ApiResponse open_example(Session& session, const ApiRequest& request) {
  std::ostringstream csv;
  write_csv(*simulate(kExampleScenario, kExampleSeed), csv);
  return open_text(session, csv.str(), std::string(kExampleScenario) + ".csv", request);
}

ApiResponse get_state(Session& session, const ApiRequest&) {
  return json_response(state_json(session));
}

ApiResponse get_effects(Session&, const ApiRequest&) {
  Json effects = Json::array();
  for (const Effect* effect : standard_catalogue().effects()) {
    const Description& d = effect->description();
    effects.push_back({{"effect", d.code},
                       {"title", d.title},
                       {"signature", d.signature},
                       {"cure", d.cure},
                       {"split", d.split}});
  }
  return json_response({{"schema", 1}, {"effects", effects}});
}

ApiResponse get_recording(Session& session, const ApiRequest&) {
  Json json = recording_json(session.view().opened());
  json["schema"] = 1;
  return json_response(json);
}

ApiResponse get_signals(Session& session, const ApiRequest&) {
  return {200, "application/json", signals_json(session.view()), {}};
}

ApiResponse post_model(Session& session, const ApiRequest& request) {
  const Json json = object_in(request);
  if (json.contains("kind")) {
    session.take(
        parse_model(request.body, file_name(value_or(request, "name", "model.json"))));
    return json_response(state_json(session));
  }
  const Json output = json.value("output", Json("y"));
  session.start(
      output_named(output.is_string() ? output.get<std::string>() : output.dump()),
      codes_in(json, "with"));
  return accepted(session);
}

ApiResponse get_model(Session& session, const ApiRequest&) {
  const SessionView view = session.view();
  return {200, "application/json", model_json(view.last().model).dump(2) + '\n',
          stem_of(view.opened().name) + ".model.json"};
}

ApiResponse get_compare(Session& session, const ApiRequest&) {
  return json_response(comparison_json(session.view().last().comparison));
}

ApiResponse post_explain(Session& session, const ApiRequest&) {
  session.explain();
  return accepted(session);
}

ApiResponse get_explain(Session& session, const ApiRequest&) {
  return json_response(explanation_json(explanation_in(session.view())));
}

ApiResponse post_add(Session& session, const ApiRequest& request) {
  const Json json = object_in(request);
  const Json effect = json.value("effect", Json(nullptr));
  if (!effect.is_string()) {
    throw BadRequest("expected {\"effect\": \"valve.stiction\"} or another code, found " +
                     workbench::quoted(request.body));
  }
  std::vector<std::string> codes = codes_in(json, "with");
  codes.insert(codes.begin(), effect.get<std::string>());
  session.add(std::move(codes));
  return accepted(session);
}

ApiResponse get_add(Session& session, const ApiRequest&) {
  const SessionView view = session.view();
  const Model& model = view.last().model;
  if (model.effects.empty() || model.history.empty()) {
    throw NotNow("nothing has been added to this model; POST /api/add first");
  }
  return json_response(added_json(model));
}

ApiResponse post_ladder(Session& session, const ApiRequest&) {
  session.climb();
  return accepted(session);
}

ApiResponse get_ladder(Session& session, const ApiRequest&) {
  const SessionView view = session.view();
  if (!view.last().ladder) {
    throw NotNow("this model was not made by the ladder; POST /api/ladder first");
  }
  return json_response(ladder_json(*view.last().ladder));
}

ApiResponse post_undo(Session& session, const ApiRequest&) {
  session.undo();
  return json_response(state_json(session));
}

ApiResponse post_cancel(Session& session, const ApiRequest&) {
  session.cancel();
  return json_response(state_json(session));
}

ApiResponse get_parts(Session& session, const ApiRequest&) {
  const SessionView view = session.view();
  const ModelReport report = report_on(view);
  const bool explained = view.last().explanation.has_value();
  const auto known = [explained](const std::string& html) {
    return explained ? Json(html) : Json(nullptr);
  };
  return json_response({{"schema", 1},
                        {"revision", view.revision},
                        {"verdict", known(model_verdict(report))},
                        {"candidates", known(candidate_list(report.explanation))},
                        {"tiles", model_tiles(report)},
                        {"ladder", ladder_figure(report)},
                        {"steps", step_table(report.model)},
                        {"residual", residual_panels(report)},
                        {"parameters", parameter_table(report.model)}});
}

ApiResponse get_report(Session& session, const ApiRequest&) {
  const SessionView view = session.view();
  static_cast<void>(explanation_in(view));
  return {200, "text/html; charset=utf-8", model_page(report_on(view)),
          stem_of(view.opened().name) + ".report.html"};
}

struct Route {
  const char* path;
  ApiResponse (*get)(Session&, const ApiRequest&);
  ApiResponse (*post)(Session&, const ApiRequest&);
};
constexpr std::array kRoutes = {
    Route{"/api/state", get_state, nullptr},
    Route{"/api/effects", get_effects, nullptr},
    Route{"/api/recording", get_recording, open_recording},
    Route{"/api/example", nullptr, open_example},
    Route{"/api/signals", get_signals, nullptr},
    Route{"/api/model", get_model, post_model},
    Route{"/api/compare", get_compare, nullptr},
    Route{"/api/explain", get_explain, post_explain},
    Route{"/api/add", get_add, post_add},
    Route{"/api/ladder", get_ladder, post_ladder},
    Route{"/api/undo", nullptr, post_undo},
    Route{"/api/cancel", nullptr, post_cancel},
    Route{"/api/parts", get_parts, nullptr},
    Route{"/api/report", get_report, nullptr},
};

ApiResponse routed(Session& session, const ApiRequest& request) {
  const auto route = std::find_if(kRoutes.begin(), kRoutes.end(),
                                  [&](const Route& r) { return request.path == r.path; });
  if (route == kRoutes.end()) {
    std::string known;
    for (const Route& r : kRoutes)
      known += (known.empty() ? "" : ", ") + std::string(r.path);
    return error_response(
        404, "no address " + workbench::quoted(request.path) + "; known: " + known);
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
  return handler(session, request);
}

}  // namespace

ApiResponse error_response(int status, const std::string& message) {
  return error_of(status, {{"message", message}});
}

ApiResponse answer(Session& session, const ApiRequest& request) {
  try {
    return routed(session, request);
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
