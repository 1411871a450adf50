#include "workbench/model/search/explain.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <utility>

#include "workbench/analysis/identification_json.hpp"
#include "workbench/analysis/wording.hpp"
#include "workbench/cli/candidates_text.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/console.hpp"
#include "workbench/cli/exit_code.hpp"
#include "workbench/cli/left_behind.hpp"
#include "workbench/cli/model_options.hpp"
#include "workbench/cli/next_file.hpp"
#include "workbench/cli/unused_columns.hpp"
#include "workbench/cli/verdict_beside.hpp"
#include "workbench/model/tell/cautions.hpp"
#include "workbench/model/tell/explanation_json.hpp"
#include "workbench/model/tell/what_to_do.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::cli {
namespace {

constexpr const char* kFooter = R"(
Examples:
  stickband explain loop.csv             what does a first-order model lack?
  stickband explain loop.csv --model m.json
  stickband explain monday.csv tuesday.csv --model m.json

Fits every effect that the model lacks, those that gain little alone in pairs, and
three together where a pair comes close and leaves more than noise.
accepted: samples that were not fitted agree, beyond chance. rejected: they do not.
not_excited: this recording never exercised it. undecided: it helps, but not beyond
doubt, or another one explains more.)";

// An accepted effect: what it is, what it may be instead, and what to do.
std::string what_is_lacking(const Candidate& best, const ExplainResult& result,
                            bool hardly, const std::optional<ValveVerdict>& verdict,
                            const SearchSoFar& so_far) {
  constexpr double kNearlyAll = 0.9;  // of the error
  const std::string aside = "The readings show " + titles_of(best) +
                            ", but hardly any of the error is its doing.";
  std::string text = !is_beside_the_point(best) ? wrapped(missing_in_words(best), 0)
                     : hardly || result.noise_rmse > kNearlyAll * result.rmse
                         ? wrapped(aside, 0)
                         : what_comes_closest(aside, result, so_far);
  text += '\n';
  for (const std::string& said : what_to_do(best, verdict && verdict->lacks_stem)) {
    text += wrapped(said, 0) + '\n';
  }
  return text + '\n';
}

std::string what_is_missing(const ExplainResult& result, bool hardly,
                            const std::optional<ValveVerdict>& verdict,
                            const SearchSoFar& so_far) {
  if (const Candidate* best = result.best()) {
    return what_is_lacking(*best, result, hardly, verdict, so_far);
  }
  if (result.left_to_controller) return "";
  // Of a model that explains nothing that is no praise.
  if (result.explained) {
    return hardly ? "" : noise_is_left("Nothing is missing", verdict) + "\n\n";
  }
  if (!result.complete) return "";
  return what_comes_closest(
             "More than noise is left, but no effect of the catalogue explains it beyond "
             "doubt.",
             result, so_far) +
         "\n\n";
}

// "Fit 71.3 %, error 2.1, validation 2.2, of which noise at most 0.4; in units of y"
std::string errors_text(const ExplainResult& result, const Recording& recording,
                        Column output) {
  const std::string& unit = recording.unit(output);
  return wrapped("Fit " + fixed(result.quality.fit_percent, 1) + " %; error " +
                     number(result.rmse, 4) + ", validation " +
                     number(result.rmse_validation, 4) + ", of which noise at most " +
                     number(result.noise_rmse, 4) + ", in " +
                     (unit.empty() ? "units of " + std::string(name_of(output)) : unit),
                 0) +
         '\n' + recordings_table(result.quality.recordings);
}

// What the readings show beside the point leaves the model as it is.
bool adds_to_the_model(const ExplainResult& result) {
  return result.with_best && !is_beside_the_point(*result.best());
}

// Of the model that the answer ends with: what the start could not tell, what is missing
// may.
std::string cautions_at_the_end(const ExplainResult& result, const Model& model,
                                const Recording& recording, const FitQuality& quality) {
  if (!adds_to_the_model(result)) return caution_text(model, recording, quality, false);
  const std::string said =
      caution_text(*result.with_best, recording, result.with_best_quality, false);
  return said.empty() ? said : "\nOf the model with what is missing:\n" + said;
}

std::string explanation_text(const ExplainResult& result, const Model& model,
                             const Recording& recording,
                             const std::optional<ValveVerdict>& verdict, bool time_was_up,
                             const SearchSoFar& so_far) {
  const bool single = result.quality.recordings.size() == 1;
  const FitQuality& quality = result.quality;
  const bool blind = result.left_to_controller;
  const bool hardly = single && tells_nothing(model, quality);
  const bool first = blind || (hardly && !adds_to_the_model(result));
  std::string text =
      first ? caution_text(model, recording, quality, blind) + '\n' : std::string();
  text += what_is_missing(result, hardly, verdict, so_far);
  if (!result.complete) {
    text += wrapped(ended_early(time_was_up, "answer"), 0) + "\n\n";
  }
  text += verdict_text(verdict) + errors_text(result, recording, model.output);
  if (single && !first) text += cautions_at_the_end(result, model, recording, quality);
  text += '\n';
  if (result.searched) {
    text += searched_text(*result.searched, "all errors and figures here.") + '\n';
  }
  return text + candidates_text(result.candidates);
}

int explain_with(const ModelOptions& options) {
  const Work work(limits_of(options));
  auto [model, read] = modelled_for(options, work);
  const Recording& recording = read.joined;
  ExplainResult result;
  std::optional<ValveVerdict> verdict;
  bool time_was_up = false;
  {
    ProgressLine line;
    VerdictBeside beside(options, std::move(read.fitted), model.output, line);
    const auto show = [&line](auto... tried) { line.trying(tried...); };
    result =
        explain(recording, model, show, standard_catalogue(), work, beside.identified());
    verdict = beside.of(work, model, result.best());
    time_was_up = work.out_of_time();
  }
  complain_about_unlike(recording, model.output, result.quality.recordings);
  complain_about_left_behind(model, recording);
  const Candidate* lacking = time_was_up ? nullptr : result.best();
  const UnusedColumns unused = complain_about_unused(
      read, model, work, lacking != nullptr ? lacking->effect : std::string());
  nlohmann::ordered_json json = explanation_json(result);
  json["identify"] = verdict_json(verdict);
  const SearchSoFar so_far{ladder_words(options, model.output),
                           model.effect_codes(),
                           {},
                           !unused.names.empty(),
                           next_file(options.model)};
  print(options.json
            ? json_line(json)
            : explanation_text(result, model, recording, verdict, time_was_up, so_far));
  return kDone;
}

}  // namespace

void add_explain(CLI::App& app, Action& action) {
  const auto options = std::make_shared<ModelOptions>();
  CLI::App* command = app.add_subcommand(
      "explain", "Tell which physical effect a model lacks, or that none is missing");
  add_model_options(*command, *options);
  add_model_file(*command, *options);
  add_work(*command, *options, true);
  runs(*command, action, options, explain_with, kFooter);
}

}  // namespace workbench::cli
