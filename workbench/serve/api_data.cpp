// Requests about what the user chooses, tries and takes along.
#include <algorithm>
#include <cmath>

#include "workbench/model/base/parameter_range.hpp"
#include "workbench/model/fit/fit.hpp"
#include "workbench/model/tell/parameter_words.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/recording/text_file.hpp"
#include "workbench/serve/api_handlers.hpp"
#include "workbench/serve/api_request.hpp"
#include "workbench/serve/command_lines.hpp"
#include "workbench/serve/session_file.hpp"
#include "workbench/serve/session_json.hpp"
#include "workbench/serve/session_step.hpp"

namespace workbench {
namespace {

using Json = nlohmann::ordered_json;

void refuse_outside(const Parameter& parameter, double value) {
  if (may_be(parameter, value)) return;
  const ParameterRange range = range_of(parameter);
  throw BadRequest(filled("expected a value of {0} from {1} to {2}, found {3}",
                          {name_in_words(parameter.name), number(range.low),
                           number(range.high), number(value)}));
}

// Sets parameters that the body names: {"process":{"gain":1.2},"valve.stiction":{…}}.
void set_values(const Json& body, const char* group, std::vector<Parameter>& parameters) {
  const Json wanted = body.value(group, Json::object());
  if (!wanted.is_object()) {
    throw BadRequest(std::string("expected an object at '") + group + "', found " +
                     workbench::quoted(wanted.dump()));
  }
  for (const auto& item : wanted.items()) {
    const auto parameter = std::ranges::find_if(parameters, [&item](const Parameter& p) {
      return !p.derived && p.name == item.key();
    });
    if (parameter == parameters.end()) {
      throw BadRequest(std::string("no parameter ") + workbench::quoted(item.key()) +
                       " in " + group);
    }
    const double value = number_in(wanted, item.key().c_str());
    refuse_outside(*parameter, value);
    parameter->value = parameter->low = parameter->high = value;
  }
  // What follows from the others is known again when the model has been fitted.
  if (!wanted.empty())
    std::erase_if(parameters, [](const Parameter& p) { return p.derived; });
}

Model model_with(const Model& model, const Json& body) {
  Model out = model;
  set_values(body, "process", out.process);
  for (EffectTerm& term : out.effects) {
    set_values(body, term.effect.c_str(), term.parameters);
  }
  return out;
}

// {"hold":{"process":["gain"]}}
HeldNames held_in(const Json& body) {
  HeldNames out;
  const Json hold = body.value("hold", Json::object());
  if (!hold.is_object()) throw BadRequest("expected an object at 'hold'");
  for (const auto& item : hold.items()) {
    for (std::string& name : codes_in(hold, item.key().c_str())) {
      out.emplace_back(item.key(), std::move(name));
    }
  }
  return out;
}

}  // namespace

ApiResponse post_try(Session& session, const ApiRequest& request) {
  const SessionView view = session.view();
  const Json body = object_in(request);
  Model model = model_with(view.last().model, body);
  const std::string then = value_or(request, "then", "");
  if (then == "keep") {
    session.take(by_hand(view.opened(), view.last().model, std::move(model), kSetByHand));
    return json_response(state_json(session));
  }
  if (then == "refit") {
    session.refit(std::move(model), held_in(body));
    return accepted(session);
  }
  const Recording& recording = view.opened();
  if (recording.size() > kMostDrawnSamples) {
    throw NotNow("this recording is too long to try parameters at once; choose a range");
  }
  const Fitter fitter(recording, model.output);
  const Fit fit = fitter.apply(model, standard_catalogue());
  const double rmse = fitter.rmse(fit);
  if (!std::isfinite(rmse)) {
    throw BadRequest("with these values the simulated output is beyond all numbers");
  }
  std::string text = "{\"schema\":1,\"rmse\":" + number(rmse, 7) +
                     ",\"rmse_validation\":" + number(fitter.rmse_on(fit, false), 7) +
                     ",\"simulated\":[";
  for (std::size_t k = 0; k < fit.residual.size(); ++k) {
    if (k > 0) text += ',';
    text += number(fitter.y()[k] - fit.residual[k], 6);
  }
  return {200, "application/json", text + "]}", {}};
}

ApiResponse post_range(Session& session, const ApiRequest& request) {
  const Json body = object_in(request);
  const std::string what = body.value("what", Json("fit")).is_string()
                               ? body.value("what", "fit")
                               : std::string();
  if (what != "fit" && what != "judge") throw BadRequest("expected what: fit or judge");
  session.choose(times_in(body),
                 what == "fit" ? Session::Purpose::kFit : Session::Purpose::kJudge);
  return accepted(session);
}

ApiResponse post_leave_out(Session& session, const ApiRequest& request) {
  const Json body = object_in(request);
  if (body.value("manual", Json()) == true) {
    session.leave_out_manual();
  } else {
    session.leave_out(times_in(body));
  }
  return accepted(session);
}

ApiResponse post_split(Session& session, const ApiRequest& request) {
  const Json body = object_in(request);
  const double period_s = session.view().opened().period_s;
  session.share_out(
      {number_in(body, "estimation_share"), number_in(body, "block_s") / period_s});
  return accepted(session);
}

ApiResponse get_models(Session& session, const ApiRequest&) {
  const SessionView view = session.view();
  Json models = Json::array();
  for (const auto& step : view.steps) {
    models.push_back(quality_json(*step, view.opened()));
  }
  return json_response({{"schema", 1}, {"models", models}});
}

ApiResponse get_simulated(Session& session, const ApiRequest& request) {
  const SessionView view = session.view();
  const std::string which = value_or(request, "model", "0");
  std::size_t at = view.steps.size();
  for (std::size_t i = 0; i < view.steps.size(); ++i) {
    if (std::to_string(i) == which) at = i;
  }
  if (at == view.steps.size()) {
    throw BadRequest("no model " + workbench::quoted(which) + "; there are " +
                     std::to_string(view.steps.size()));
  }
  return {200, "application/json", simulated_json(view, *view.steps[at]), {}};
}

ApiResponse get_session(Session& session, const ApiRequest&) {
  const SessionView view = session.view();
  return {200, "application/json", session_text(view),
          stem_of(view.opened().name) + ".session.json"};
}

ApiResponse post_session(Session& session, const ApiRequest& request) {
  SavedSession saved =
      parse_session(request.body, file_name(value_or(request, "name", "session.json")));
  session.restore(std::move(saved.recording), std::move(saved.source),
                  std::move(saved.steps), std::move(saved.undone),
                  std::move(saved.beside), turn_in(request));
  session.say_opens(saved.opens);
  return accepted(session);
}

ApiResponse get_csv(Session& session, const ApiRequest&) {
  const SessionView view = session.view();
  const Recording& recording = view.opened();
  const ModelStep* step = view.steps.empty() ? nullptr : view.steps.back().get();
  std::string text = "t,u";
  std::vector<const std::vector<double>*> columns = {&recording.t, &recording.u};
  const auto add = [&](const std::string& name, const std::vector<double>& values) {
    if (values.empty()) return;
    text += ',' + name;
    columns.push_back(&values);
  };
  for (const Column column : {Column::y, Column::sp, Column::x}) {
    add(std::string(name_of(column)), recording.values(column));
  }
  if (step != nullptr) {
    add("simulated", step->comparison.simulated);
    add("residual", step->comparison.residual);
  }
  text += '\n';
  for (std::size_t k = 0; k < recording.size(); ++k) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (i > 0) text += ',';
      text += number((*columns[i])[k], i == 0 ? 15 : 9);
    }
    text += '\n';
  }
  return {200, "text/csv; charset=utf-8", std::move(text),
          stem_of(recording.name) + ".signals.csv"};
}

ApiResponse get_commands(Session& session, const ApiRequest&) {
  return json_response({{"schema", 1}, {"commands", command_lines(session.view())}});
}

}  // namespace workbench
