// Requests about what is looked at before it is taken: a preview of effects, and the
// model on recordings that lie beside the one that is open.
#include <algorithm>

#include "workbench/recording/own_readings.hpp"
#include "workbench/recording/text_file.hpp"
#include "workbench/report/svg_plot.hpp"
#include "workbench/serve/api_handlers.hpp"
#include "workbench/serve/api_request.hpp"
#include "workbench/serve/command_lines.hpp"
#include "workbench/serve/session_json.hpp"

namespace workbench {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDrawnPixels = 900;

// A few values for each pixel, with every peak.
Json picture_of(const Recording& recording, const std::vector<double>& measured,
                const std::vector<double>& simulated) {
  Json out = {
      {"t", Json::array()}, {"measured", Json::array()}, {"simulated", Json::array()}};
  for (const std::size_t k : visible_points(measured, kDrawnPixels)) {
    out["t"].push_back(recording.t[k] - recording.t.front());
    out["measured"].push_back(measured[k]);
    if (!simulated.empty()) out["simulated"].push_back(simulated[k]);
  }
  return out;
}

// What the model says about another recording, or why it cannot.
Json judged(const BesideRecording& other, const ModelStep* step) {
  const Recording& recording = *other.recording;
  Json out = recording_json(recording);
  out["fitted"] = other.fitted;
  const Column output = step != nullptr ? step->model.output : usual_output(recording);
  if (step == nullptr) {
    out["picture"] = picture_of(recording, recording.values(output), {});
    return out;
  }
  try {
    const Comparison comparison = compare(recording, step->model);
    out["fit_percent"] = comparison.quality.fit_percent;
    out["rmse"] = out["rmse_validation"] = comparison.quality.rmse;  // none was fitted
    out["picture"] =
        picture_of(recording, recording.values(output), comparison.simulated);
  } catch (const std::exception&) {
    out["error"] = error_json(std::current_exception());
  }
  return out;
}

template <class Errors>
Json errors_of(const Errors& errors) {
  return {{"fit_percent", errors.fit_percent},
          {"rmse", errors.rmse},
          {"rmse_validation", errors.rmse_validation}};
}

// Of recordings that are fitted together: what the fit of all says of each.
void take_parts(const SessionView& view, const ModelStep& step, Json& own,
                Json& recordings) {
  const std::vector<RecordingFit>& parts = step.comparison.quality.recordings;
  std::size_t next = 0;
  const auto take = [&](Json& to) {
    if (next < parts.size()) to.update(errors_of(parts[next++]));
  };
  take(own);
  for (std::size_t i = 0; i < view.beside.size(); ++i) {
    if (view.beside[i].fitted) take(recordings[i]);
  }
}

// Reads it as it is asked for; where nothing is, as the one that is open was read, at its
// sample period only without times of its own, or else as any file. `options` are then
// those it was read with. Throws as parse_csv() for the last of these.
Recording read_like(const CsvOptions* first, bool asked, const std::string& text,
                    const std::string& name, CsvOptions& options) {
  if (!asked && first != nullptr) {
    CsvOptions like = *first;
    like.required = options.required;
    std::vector<std::optional<double>> periods = {std::nullopt};
    if (first->ts) periods.push_back(first->ts);
    for (const std::optional<double>& ts : periods) {
      try {
        like.ts = ts;
        Recording recording = parse_csv(text, name, like);
        options = like;
        return recording;
      } catch (const std::exception&) {
        continue;
      }
    }
  }
  return parse_csv(text, name, options);
}

// Whether it says how the file is to be read.
bool tells_how(const ApiRequest& request) {
  return std::ranges::any_of(request.query, [](const auto& item) {
    return item.first != "name" && item.first != "opening" && !item.second.empty();
  });
}

std::size_t index_in(const Json& body) {
  const double which = number_in(body, "which");
  if (!(which >= 0 && which < 1000)) {
    throw BadRequest("expected the number of a recording from 0 on");
  }
  return static_cast<std::size_t>(which);
}

}  // namespace

ApiResponse post_preview(Session& session, const ApiRequest& request) {
  session.preview(effects_in(request));
  return accepted(session);
}

ApiResponse get_preview(Session& session, const ApiRequest&) {
  const SessionView view = session.view();
  if (view.preview == nullptr) {
    throw NotNow("nothing is previewed; POST /api/preview first");
  }
  Json json = quality_json(*view.preview->step, view.opened());
  json["schema"] = 1;
  json["previewed"] = view.preview->effects;
  json["before"] = quality_json(view.last(), view.opened());
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  // The samples come as text, for they are many.
  const std::string samples = simulated_json(view, *view.preview->step);
  text.back() = ',';
  return {
      200, "application/json", text + samples.substr(samples.find("\"simulated\"")), {}};
}

ApiResponse post_beside(Session& session, const ApiRequest& request) {
  const SessionView view = session.view();
  CsvOptions options = csv_options(request);
  const Column output = view.output();
  options.required = {Column::u, output};
  const std::string name = file_name(value_or(request, "name", "recording.csv"));
  Recording recording =
      read_like(view.reading.get(), tells_how(request), request.body, name, options);
  recording.name = name;
  leave_out_own_readings(recording);
  session.accompany(std::move(recording), source_words(name, options));
  return json_response(state_json(session));
}

ApiResponse get_beside(Session& session, const ApiRequest&) {
  const SessionView view = session.view();
  const ModelStep* step = view.steps.empty() ? nullptr : view.steps.back().get();
  Json recordings = Json::array();
  for (const BesideRecording& other : view.beside) {
    recordings.push_back(judged(other, step));
  }
  Json own;
  if (step != nullptr) own = errors_of(step->comparison.quality);
  if (view.own != nullptr && step != nullptr) take_parts(view, *step, own, recordings);
  return json_response({{"schema", 1}, {"own", own}, {"recordings", recordings}});
}

ApiResponse post_together(Session& session, const ApiRequest& request) {
  const Json body = object_in(request);
  const Json fit = body.value("fit", Json());
  if (!fit.is_boolean()) throw BadRequest("expected true or false at 'fit'");
  session.fit_together(index_in(body), fit.get<bool>());
  return accepted(session);
}

ApiResponse post_dismiss(Session& session, const ApiRequest& request) {
  session.dismiss(index_in(object_in(request)));
  return json_response(state_json(session));
}

}  // namespace workbench
