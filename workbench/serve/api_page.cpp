// Requests for what is shown and saved.
#include <algorithm>

#include "workbench/effects/catalogue.hpp"
#include "workbench/model/tell/model_json.hpp"
#include "workbench/model/tell/reconciled.hpp"
#include "workbench/report/model_page.hpp"
#include "workbench/report/model_parts.hpp"
#include "workbench/report/translated_page.hpp"
#include "workbench/serve/api_handlers.hpp"
#include "workbench/serve/api_request.hpp"
#include "workbench/serve/axis_times.hpp"
#include "workbench/serve/direction_words.hpp"
#include "workbench/serve/effect_titles.hpp"
#include "workbench/serve/languages.hpp"

namespace workbench {
namespace {

using Json = nlohmann::ordered_json;

ident::Verdict verdict_in(const SessionView& view) {
  return view.valve->analysis.result().verdict;
}

ModelReport report_on(const SessionView& view) {
  const ModelStep& step = view.last();
  ModelReport report{view.opened(), step.model, step.comparison,
                     step.explanation.value_or(ExplainResult{})};
  report.lacks_stem = view.valve != nullptr && lacks_stem(verdict_in(view), report.model,
                                                          report.explanation.best());
  return report;
}

Json missing_in(const ModelReport& report) {
  const Candidate* missing = report.explanation.best();
  return missing != nullptr ? Json(missing->effect) : Json(nullptr);
}

// What the page says of models, in the words of the page.
std::string worded(const std::string& html, const SessionView& view) {
  return in_direction_words(with_effect_titles(with_axis_times(html, view.opened())),
                            view.opens);
}

// Where each failure is at its worst, [from, to]; null where it is nowhere.
Json places_of(const ModelReport& report) {
  Json out = Json::array();
  const std::vector<double>& t = report.recording.t;
  for (const Failure& failure : report.comparison.failures) {
    const bool somewhere = failure.first < failure.last && failure.last <= t.size();
    out.push_back(somewhere ? Json({t[failure.first], t[failure.last - 1]})
                            : Json(nullptr));
  }
  return out;
}

}  // namespace

std::string stem_of(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos || dot == 0 ? name : name.substr(0, dot);
}

ApiResponse get_effects(Session&, const ApiRequest&) {
  Json effects = Json::array();
  for (const Effect* effect : standard_catalogue().effects()) {
    const Description& d = effect->description();
    effects.push_back(
        {{"effect", d.code},
         {"title", d.title},
         {"signature", d.signature},
         {"cure", (d.harmless ? "Nothing is broken. " : "") + std::string(d.cure)},
         {"split", d.split}});
  }
  return json_response({{"schema", 1}, {"effects", effects}});
}

ApiResponse get_model(Session& session, const ApiRequest&) {
  const SessionView view = session.view();
  return {200, "application/json", model_json(view.last().model).dump(2) + '\n',
          stem_of(view.opened().name) + ".model.json"};
}

ApiResponse get_parts(Session& session, const ApiRequest&) {
  const SessionView view = session.view();
  const ModelReport report = report_on(view);
  const bool explained = view.last().explanation.has_value();
  const auto known = [explained, &view](const std::string& html) {
    return explained ? Json(worded(html, view)) : Json(nullptr);
  };
  return json_response(
      {{"schema", 1},
       {"revision", view.revision},
       {"verdict", known(model_verdict(report))},
       {"reconciled",
        known(explained && view.valve != nullptr
                  ? reconciled(verdict_in(view), report.model, report.explanation.best())
                  : "")},
       {"missing", missing_in(report)},
       {"candidates", known(candidate_list(report.explanation))},
       {"tiles", model_tiles(report)},
       {"ladder", ladder_figure(report)},
       {"steps", step_table(report.model)},
       {"residual", worded(residual_panels(report), view)},
       {"places", places_of(report)},
       {"parameters", worded(parameter_table(report), view)}});
}

ApiResponse get_report(Session& session, const ApiRequest& request) {
  const std::string language = value_or(request, "language", "en");
  const std::vector<std::string>& known = languages();
  if (std::ranges::find(known, language) == known.end()) {
    throw BadRequest("no language " + workbench::quoted(language));
  }
  const SessionView view = session.view();
  static_cast<void>(explanation_in(view));
  std::optional<ReportData> valve;
  if (view.valve != nullptr) {
    valve.emplace(ReportData{*view.recording, view.valve->analysis,
                             view.valve->simulation, std::nullopt});
  }
  return {200, "text/html; charset=utf-8",
          translated_page(
              worded(model_page(report_on(view), valve ? &*valve : nullptr), view),
              texts_of(language), language),
          stem_of(view.opened().name) + ".report.html"};
}

}  // namespace workbench
