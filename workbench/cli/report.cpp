#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "workbench/analysis/analysis.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/console.hpp"
#include "workbench/cli/exit_code.hpp"
#include "workbench/cli/output_file.hpp"
#include "workbench/cli/recording_options.hpp"
#include "workbench/report/report_page.hpp"

namespace workbench::cli {
namespace {

struct Options {
  RecordingSource source;
  std::string output;
  std::string truth;
};

constexpr const char* kFooter = R"(
Examples:
  stickband report loop.csv -o loop.html
  stickband report loop.csv --truth loop.json -o loop.html

The page needs no other file and no network. With --truth, the file that stickband
simulate wrote, the identified valve is drawn beside the true one.)";

int report(const Options& options) {
  std::error_code ignored;
  for (const std::string& input :
       {options.source.path, options.source.dbc, options.truth}) {
    if (!input.empty() && std::filesystem::equivalent(input, options.output, ignored)) {
      throw UsageError("-o would replace " + input + ", which is read");
    }
  }
  std::optional<KnownTruth> truth;
  if (!options.truth.empty()) truth = read_truth(options.truth);
  const Recording recording = read(options.source);
  Analysis analysis = identify_with_progress(recording);
  Simulation simulation = analysis.simulate();
  const ReportData data{recording, analysis, std::move(simulation), std::move(truth)};
  write_file(options.output, report_page(data));
  return kDone;
}

}  // namespace

void add_report(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "report", "Write a page with the verdict, the numbers and the pictures");
  add_recording_options(*command, options->source);
  command->add_option("-o,--output", options->output, "the page")
      ->type_name("report.html")
      ->required();
  command
      ->add_option("--truth", options->truth, "what is true about a simulated recording")
      ->type_name("TRUTH.json");
  command->footer(kFooter);
  command->callback(
      [&action, options] { action = [options] { return report(*options); }; });
}

}  // namespace workbench::cli
