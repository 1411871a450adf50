#include "workbench/serve/session_json.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include "workbench/model/base/joined.hpp"
#include "workbench/model/fit/fit.hpp"
#include "workbench/model/tell/curve_of.hpp"
#include "workbench/model/tell/model_json.hpp"
#include "workbench/model/tell/parameter_words.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/report/svg_plot.hpp"
#include "workbench/serve/marks.hpp"

namespace workbench {
namespace {

using Json = nlohmann::ordered_json;
using Indices = std::vector<std::size_t>;

Json job_json(const WorkProgress& progress) {
  return {{"task", progress.task},       {"detail", progress.detail},
          {"number", progress.number},   {"of", progress.of},
          {"seconds", progress.seconds}, {"stopping", progress.stopping}};
}

Json summary_of(const ModelStep& step) {
  const Json model = model_json(step.model);
  return {{"output", model["output"]},
          {"effects", step.model.effect_codes()},
          {"fitted_to", step.model.fitted.name},
          {"fitted_here", step.fitted_here},
          {"belongs_elsewhere", belongs_elsewhere(step)},
          {"fit_percent", step.comparison.quality.fit_percent},
          {"rmse", step.comparison.quality.rmse},
          {"rmse_validation", step.comparison.quality.rmse_validation},
          {"ended_early", step.ladder && !step.ladder->complete},
          {"history", model["history"]}};
}

// What a number may stand for: [[0, "…"], [1, "…"]]; empty where it is a number.
Json choices_of(Parameter parameter) {
  constexpr int kMost = 8;
  Json out = Json::array();
  for (int value = 0; value < kMost; ++value) {
    parameter.value = value;
    const std::string words = choice_in_words(parameter);
    if (!words.empty()) out.push_back({value, words});
  }
  return out;
}

// What the page calls them.
void add_words(const std::vector<Parameter>& parameters, const Recording& recording,
               Column output, Json& json) {
  for (const Parameter& p : parameters) {
    Json& own = json[p.name];
    own["words"] = name_in_words(p.name);
    own["unit_in_words"] = unit_in_words(p, recording, output);
    const std::string choice = choice_in_words(p);
    if (choice.empty()) continue;
    own["choice"] = choice;
    own["choices"] = choices_of(p);
  }
}

std::string_view verdict_in(const ValveAnswer& valve) {
  return ident::name(valve.analysis.result().verdict);
}

Json split_json(const Recording& recording) {
  return {{"estimation_share", recording.split.estimation_share},
          {"block_s", recording.split.pair_samples * recording.period_s}};
}

// The samples that show every signal: of each stretch its ends and extremes.
Indices drawn(std::size_t samples,
              const std::vector<const std::vector<double>*>& signals) {
  Indices out;
  if (samples <= kMostDrawnSamples) {
    for (std::size_t k = 0; k < samples; ++k) out.push_back(k);
    return out;
  }
  const auto share = static_cast<int>(kMostDrawnSamples / (4 * signals.size()));
  for (const std::vector<double>* signal : signals) {
    const Indices some = visible_points(*signal, share);
    out.insert(out.end(), some.begin(), some.end());
  }
  std::ranges::sort(out);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

void append(std::string& text, const char* name, const std::vector<double>& values,
            const Indices& at, int digits) {
  text += std::string(",\"") + name + "\":[";
  char number[40];
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (i > 0) text += ',';
    if (!std::isfinite(values[at[i]])) {
      text += "null";
      continue;
    }
    const auto end = std::to_chars(number, number + sizeof number, values[at[i]],
                                   std::chars_format::general, digits);
    text.append(number, end.ptr);
  }
  text += ']';
}

}  // namespace

const char* word_of(Opens opens) {
  return opens == Opens::yes ? "yes" : opens == Opens::no ? "no" : "";
}

bool belongs_elsewhere(const ModelStep& step) {
  return !step.fitted_here && step.comparison.quality.fit_percent < 0;
}

Json recording_json(const Recording& recording) {
  Json columns = Json::array();
  Json units = Json::object();
  for (const Column column : kLoopColumns) {
    if (!recording.has(column)) continue;
    columns.push_back(name_of(column));
    if (!recording.unit(column).empty()) {
      units[std::string(name_of(column))] = recording.unit(column);
    }
  }
  return {{"name", recording.name},
          {"samples", recording.size()},
          {"sample_period_s", recording.period_s},
          {"from_s", recording.t.front()},
          {"start", recording.start.empty() ? Json(nullptr) : Json(recording.start)},
          {"columns", columns},
          {"tags", recording.tags},
          {"units", units},
          {"notes", recording.resampling.notes}};
}

Json quality_json(const ModelStep& step, const Recording& recording) {
  Json out = model_json(step.model);
  for (const char* key : {"recording", "initial_state", "schema", "kind"}) out.erase(key);
  const Column output = step.model.output;
  add_words(step.model.process, recording, output, out["process"]);
  for (std::size_t i = 0; i < step.model.effects.size(); ++i) {
    const EffectTerm& term = step.model.effects[i];
    Json& parameters = out["effects"][i]["parameters"];
    add_words(term.parameters, recording, output, parameters);
    for (const Parameter& p : term.parameters) {
      if (is_idle(term, p.name)) parameters[p.name]["idle"] = true;
    }
  }
  out["fit_percent"] = step.comparison.quality.fit_percent;
  out["rmse"] = step.comparison.quality.rmse;
  out["rmse_validation"] = step.comparison.quality.rmse_validation;
  out["explained"] = step.explanation ? Json(step.explanation->explained) : Json(nullptr);
  return out;
}

Json error_json(const std::exception_ptr& error) {
  try {
    std::rethrow_exception(error);
  } catch (const InputError& e) {
    return {{"kind", "bad_input"}, {"message", e.what()}, {"file", e.file},
            {"line", e.line},      {"column", e.column},  {"expected", e.expected},
            {"found", e.found},    {"advice", e.advice}};
  } catch (const std::invalid_argument& e) {
    return {{"kind", "cannot_answer"}, {"message", e.what()}};
  } catch (const std::exception& e) {
    return {{"kind", "failed"}, {"message", e.what()}};
  } catch (...) {
    return {{"kind", "failed"}, {"message", "unknown error"}};
  }
}

Json state_json(const Session& session) {
  // In this order: work that ends in between shows in the view.
  const std::optional<WorkProgress> job = session.progress();
  const std::exception_ptr failure = session.failure();
  const std::optional<WorkProgress> verdict_job = session.verdict_progress();
  const std::exception_ptr verdict_failure = session.verdict_failure();
  const SessionView view = session.view();
  const ModelStep* last = view.steps.empty() ? nullptr : view.steps.back().get();
  Json beside = Json::array();
  Json fitted = Json::array();
  for (const BesideRecording& other : view.beside) {
    beside.push_back(other.recording->name);
    fitted.push_back(other.fitted);
  }
  const bool asked = last != nullptr && last->explanation.has_value();
  const auto if_any = [](const auto& one, auto told) {
    return one ? Json(told(*one)) : Json(nullptr);
  };
  return {
      {"schema", 1},
      {"version", STICKBAND_VERSION},
      {"revision", view.revision},
      {"drawn", view.drawn},
      {"opened", view.opened_count},
      {"opening", view.opening},
      {"begun", session.begun()},
      {"is_range", view.whole != nullptr},
      {"left_out", view.recording != nullptr && !view.recording->left_out.empty()},
      {"split", if_any(view.recording, split_json)},
      {"recording", if_any(view.recording, recording_json)},
      {"verdict", if_any(view.valve, verdict_in)},
      {"verdict_so_far", if_any(view.valve_so_far, verdict_in)},
      {"verdict_job", if_any(verdict_job, job_json)},
      {"verdict_error",
       verdict_failure != nullptr ? error_json(verdict_failure) : Json(nullptr)},
      {"model", if_any(last, summary_of)},
      {"explained", asked ? Json(last->explanation->explained) : Json(nullptr)},
      {"opens", word_of(view.opens)},
      {"stopped", last != nullptr && view.is_stopped()},
      {"preview", view.preview != nullptr ? Json(view.preview->effects) : Json(nullptr)},
      {"beside_own", view.own != nullptr         ? Json(view.own->name)
                     : view.recording != nullptr ? Json(view.recording->name)
                                                 : Json(nullptr)},
      {"beside", beside},
      {"beside_fitted", fitted},
      {"can_undo", view.can_undo()},
      {"can_redo", !view.undone.empty()},
      {"job", if_any(job, job_json)},
      {"error", failure != nullptr ? error_json(failure) : Json(nullptr)}};
}

namespace {

Indices drawn_of(const SessionView& view) {
  const Recording& recording = view.opened();
  std::vector<const std::vector<double>*> signals = {&recording.u,
                                                     &recording.values(view.output())};
  if (!view.steps.empty()) signals.push_back(&view.steps.back()->comparison.simulated);
  return drawn(recording.size(), signals);
}

}  // namespace

std::string simulated_json(const SessionView& view, const ModelStep& step) {
  std::string text = "{\"schema\":1";
  append(text, "simulated", step.comparison.simulated, drawn_of(view), 7);
  return text + '}';
}

std::string signals_json(const SessionView& view) {
  const Recording& recording = view.opened();
  const ModelStep* last = view.steps.empty() ? nullptr : view.steps.back().get();
  const Column output = view.output();
  const std::vector<double>& measured = recording.values(output);
  const Indices at = drawn_of(view);
  std::string text = "{\"schema\":1,\"output\":\"" + std::string(name_of(output)) +
                     "\",\"samples\":" + std::to_string(recording.size());
  constexpr int kDigits = 7;
  append(text, "t", recording.t, at, 15);
  append(text, "u", recording.u, at, kDigits);
  append(text, "measured", measured, at, kDigits);
  if (output == Column::y && recording.has(Column::sp)) {
    append(text, "sp", recording.sp, at, kDigits);
  }
  if (last != nullptr) {
    append(text, "simulated", last->comparison.simulated, at, kDigits);
    append(text, "residual", last->comparison.residual, at, kDigits);
  }
  Json marks = Json::array();
  for (const Mark& mark : marks_of(recording)) {
    marks.push_back({mark.from_s, mark.to_s, name_of(mark.kind)});
  }
  Json left_out = Json::array();
  for (const SampleRange& range : parts_of(recording).left_out) {
    left_out.push_back({recording.t[range.first], recording.t[range.last - 1]});
  }
  Json blocks = Json::array();
  if (last != nullptr) {
    const Fitter fitter(recording, output);
    for (const Block& block : fitter.blocks().blocks()) {
      blocks.push_back({recording.t[block.first], recording.t[block.last - 1],
                        block.estimation ? 1 : 0});
    }
  }
  Json pieces = Json::array();
  for (const Piece& piece : recording.pieces) {
    pieces.push_back({recording.t[piece.first], recording.t[piece.last - 1],
                      piece.recording, piece.start_s});
  }
  return text + ",\"marks\":" + marks.dump() + ",\"left_out\":" + left_out.dump() +
         ",\"blocks\":" + blocks.dump() +
         ",\"pieces\":" + pieces.dump(-1, ' ', false, Json::error_handler_t::replace) +
         '}';
}

}  // namespace workbench
