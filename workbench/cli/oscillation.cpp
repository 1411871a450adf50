#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <utility>

#include "ident/signal/movement.hpp"
#include "ident/signal/oscillation_detector.hpp"
#include "workbench/analysis/identification_json.hpp"
#include "workbench/analysis/oscillation_json.hpp"
#include "workbench/analysis/wording.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/console.hpp"
#include "workbench/cli/exit_code.hpp"
#include "workbench/cli/recording_options.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/recording/signal_suggestion.hpp"
#include "workbench/recording/tag_file.hpp"
#include "workbench/recording/text_file.hpp"

namespace workbench::cli {
namespace {

struct Options {
  RecordingSource source;
  std::string column = "u";
  bool column_given = false;
  bool json = false;
};

constexpr const char* kFooter = R"(
Examples:
  stickband oscillation loop.csv
  stickband oscillation loop.csv --column y --json

Sees periods of 4 to 500 samples. Regularity above 1 means that the signal oscillates;
amplitude is half the peak-to-peak swing of the fundamental wave. Period and amplitude
are null in JSON where no oscillation is seen.)";

using Report = ident::OscillationReport<double>;

std::string human_text(const Report& report, const Recording& recording,
                       const std::string& column) {
  std::string text = recording.name + ": " + column + ", " +
                     std::to_string(recording.size()) + " samples, one every " +
                     number(recording.period_s) + " s\n\n";
  if (!report.detected && report.regularity > 1) {
    return text + "No oscillation: it repeats itself (regularity " +
           fixed(report.regularity, 1) + "), but hardly turns back, as a staircase.\n";
  }
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

// The signal of a file that holds one alone, unless another column was asked for.
std::optional<Recording> read_only_signal(RecordingSource source, Column column,
                                          bool column_given) {
  ColumnNames& names = source.names;
  if (!source.dbc.empty() || !source.config.empty() || names.names_signals()) {
    return std::nullopt;
  }
  const auto file =
      tag_file(read_text_file(source.path, kMostBytes), source.path, source);
  if (!file) return std::nullopt;
  const Part part = column_name(file->tag).part;
  const bool other = is_signal(part) && part != part_of(column);
  if (column_given && other) return std::nullopt;
  std::string& name = column == Column::u   ? names.u
                      : column == Column::y ? names.y
                      : column == Column::x ? names.x
                                            : names.sp;
  // Of a file that names its tag in each row, it is the first of its tags.
  for (const std::string& number :
       {'#' + std::to_string(file->value + 1), std::string("#1")}) {
    name = number;
    try {
      Recording out = read(source);
      out.resampling.notes.push_back("taken as the only signal of the file: " +
                                     workbench::quoted(file->tag));
      return out;
    } catch (const std::exception&) {
      continue;
    }
  }
  return std::nullopt;
}

// The column that the file has by its name; else the only signal, or what identify takes
// for it beside the other one.
Recording read_signal(RecordingSource source, Column column, bool column_given) {
  source.required = {column};
  try {
    return read(source);
  } catch (const InputError&) {
    if (auto only = read_only_signal(source, column, column_given))
      return std::move(*only);
    if (column != Column::u && column != Column::y) throw;
    try {
      source.required = {Column::u, Column::y};
      return read(source);
    } catch (const InputError&) {
    }
    throw;
  }
}

int detect(const Options& options) {
  const Column column = column_named(options.column).value();
  const Recording recording = read_signal(options.source, column, options.column_given);
  ident::OscillationDetector<double> detector;
  for (const double value : recording.values(column)) detector.push(value);
  Report report = detector.report();
  report.detected =
      report.detected &&
      ident::turns_in_cycles<double>(recording.values(column), report, report.amplitude);
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
  command->callback([&action, options, command] {
    options->column_given = command->count("--column") > 0;
    action = [options] { return detect(*options); };
  });
}

}  // namespace workbench::cli
