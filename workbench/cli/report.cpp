#include <CLI/CLI.hpp>
#include <memory>
#include <utility>

#include "workbench/analysis/analysis.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/console.hpp"
#include "workbench/cli/exit_code.hpp"
#include "workbench/cli/model_options.hpp"
#include "workbench/cli/output_file.hpp"
#include "workbench/cli/recording_options.hpp"
#include "workbench/cli/unused_columns.hpp"
#include "workbench/model/base/one_loop.hpp"
#include "workbench/model/tell/reconciled.hpp"
#include "workbench/report/model_page.hpp"
#include "workbench/report/report_page.hpp"
#include "workbench/report/translated_page.hpp"
#include "workbench/serve/languages.hpp"

namespace workbench::cli {
namespace {

struct Options {
  ModelOptions model;  ///< its target is the page
  std::string truth;
  std::string language = "en";
};

constexpr const char* kFooter = R"(
Examples:
  stickband report loop.csv -o loop.html
  stickband report loop.csv --truth loop.json -o loop.html
  stickband report loop.csv --model m.json -o model.html
  stickband report loop.csv --language de -o loop.html

The page needs no other file and no network. With --truth, the file that stickband
simulate wrote, the identified valve is drawn beside the true one. With --model, the
page also tells where that model fails, what it lacks, and how its error fell.)";

std::string identification(const Options& options) {
  if (!options.model.output.empty()) throw UsageError("--output needs --model");
  std::optional<KnownTruth> truth;
  if (!options.truth.empty()) truth = read_truth(options.truth);
  if (!options.model.judging.empty()) throw UsageError("--validate needs --model");
  complain_about_loads(options.model.source);
  std::vector<Recording> recordings = recordings_for(options.model, Column::y);
  check_one_loop(recordings);
  Recording recording = recordings.front();
  for (const std::string& note : overlaps_of(recordings)) {
    recording.resampling.notes.push_back(note);
  }
  std::vector<std::string> others;
  for (std::size_t i = 1; i < recordings.size(); ++i)
    others.push_back(recordings[i].name);
  Analysis analysis = identify_with_progress(std::move(recordings), options.model.source);
  const ReportData data{recording, analysis, analysis.simulate(), std::move(truth),
                        std::move(others)};
  return report_page(data);
}

std::string comparison(const ModelOptions& options) {
  auto [model, read] = modelled_for(options, Work::unlimited());
  const Recording& recording = read.joined;
  ModelReport report = [&] {
    ProgressLine line;
    return ModelReport{
        recording, model, compare(recording, model),
        explain(recording, model, [&line](auto... tried) { line.trying(tried...); })};
  }();
  complain_about_unused(read, model);
  if (!recording.has(Column::y)) return model_page(report);
  Analysis analysis = identify_with_progress(model.output == Column::y
                                                 ? std::move(read.fitted)
                                                 : recordings_for(options, Column::y),
                                             options.source);
  report.lacks_stem =
      lacks_stem(analysis.result().verdict, model, report.explanation.best());
  const ReportData valve{recording, analysis, analysis.simulate(), std::nullopt};
  return model_page(report, &valve);
}

int report(const Options& options) {
  refuse_to_replace_inputs(options.model);
  refuse_to_replace(options.model.model, options.model.target);
  refuse_to_replace(options.truth, options.model.target);
  const std::string page =
      options.model.model.empty() ? identification(options) : comparison(options.model);
  write_file(options.model.target,
             translated_page(page, texts_of(options.language), options.language));
  complain("wrote " + options.model.target);
  return kDone;
}

}  // namespace

void add_report(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "report", "Write a page with the verdict, the numbers and the pictures");
  ModelOptions& model = options->model;
  add_recordings(*command, model);
  command->add_option("-o,--output-file", model.target, "the page")
      ->type_name("report.html")
      ->required();
  CLI::Option* truth = command
                           ->add_option("--truth", options->truth,
                                        "what is true about a simulated recording")
                           ->type_name("TRUTH.json");
  command->add_option("--model", model.model, "report on this model of the recording")
      ->type_name("M.json")
      ->excludes(truth);
  command->add_option("--output", model.output, "what the model is of: y, or x")
      ->type_name("y|x")
      ->check(CLI::IsMember({"y", "x"}));
  command->add_option("--language", options->language, "of the page, default en")
      ->type_name("CODE")
      ->check(CLI::IsMember(languages()));
  runs(*command, action, options, report, kFooter);
}

}  // namespace workbench::cli
