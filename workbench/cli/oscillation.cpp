#include <CLI/CLI.hpp>
#include <memory>

#include "ident/signal/oscillation_detector.hpp"
#include "workbench/analysis/identification_json.hpp"
#include "workbench/analysis/oscillation_json.hpp"
#include "workbench/analysis/wording.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/console.hpp"
#include "workbench/cli/exit_code.hpp"
#include "workbench/cli/recording_options.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::cli {
namespace {

struct Options {
  RecordingSource source;
  std::string column = "u";
  bool json = false;
};

constexpr const char* kFooter = R"(
Examples:
  stickband oscillation loop.csv
  stickband oscillation loop.csv --column y --json

Sees periods of 4 to 500 samples. Regularity above 1 means that the signal oscillates;
amplitude is half the peak-to-peak swing of the fundamental wave. Period and amplitude
are null in JSON where no oscillation is seen.)";

Column column_named(const std::string& name) {
  for (const Column column : {Column::u, Column::y, Column::sp, Column::x}) {
    if (name == name_of(column)) return column;
  }
  throw UsageError("no column '" + name + "'");
}

using Report = ident::OscillationReport<double>;

std::string human_text(const Report& report, const Recording& recording,
                       const std::string& column) {
  std::string text = recording.name + ": " + column + ", " +
                     std::to_string(recording.size()) + " samples, one every " +
                     number(recording.period_s) + " s\n\n";
  if (!report.detected) {
    return text + "No oscillation. Regularity " + fixed(report.regularity, 2) +
           "; above 1 it would be one.\n";
  }
  constexpr int kFew = 3;  // cycles: a single move and its echo make as many
  const char* const verdict =
      report.cycles > kFew
          ? "It oscillates."
          : "It may oscillate: so few cycles may be a single move; record for longer.";
  return text + verdict + "\n  Period      " +
         duration(report.period_samples * recording.period_s) + "\n  Amplitude   " +
         number(report.amplitude, 3) + "\n  Regularity  " + fixed(report.regularity, 1) +
         " (above 1 is an oscillation)\n  Cycles      " + std::to_string(report.cycles) +
         '\n';
}

int detect(Options options) {
  const Column column = column_named(options.column);
  options.source.required = {column};
  const Recording recording = read(options.source);
  ident::OscillationDetector<double> detector;
  for (const double value : recording.values(column)) detector.push(value);
  const Report report = detector.report();
  for (const std::string& note : recording.resampling.notes) complain(note);
  print(options.json ? json_line(oscillation_json(report, recording.period_s))
                     : human_text(report, recording, options.column));
  return kDone;
}

}  // namespace

void add_oscillation(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("oscillation", "Tell whether one signal oscillates, and how");
  add_recording_options(*command, options->source);
  command->add_option("--column", options->column, "the signal: u, y, sp or x")
      ->check(CLI::IsMember({"u", "y", "sp", "x"}))
      ->capture_default_str();
  command->add_flag("--json", options->json, "one JSON object instead of text");
  command->footer(kFooter);
  command->callback(
      [&action, options] { action = [options] { return detect(*options); }; });
}

}  // namespace workbench::cli
