#include <CLI/CLI.hpp>
#include <memory>

#include "workbench/analysis/analysis.hpp"
#include "workbench/analysis/identification_json.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/console.hpp"
#include "workbench/cli/exit_code.hpp"
#include "workbench/cli/identification_text.hpp"
#include "workbench/cli/recording_options.hpp"

namespace workbench::cli {
namespace {

struct Options {
  RecordingSource source;
  bool json = false;
};

constexpr const char* kFooter = R"(
Examples:
  stickband identify loop.csv
  stickband identify loop.csv --ts 0.5 --json
  stickband identify export.csv --u FIC101.OP --y FIC101.PV
  stickband identify bus.log --dbc plant.dbc --u LoopOP.OP --y LoopPV.PV

Verdicts: stiction, backlash, no_stiction, undecided, bad_data. With the last two the
exit code is 4, and stderr says what data would tell. The stick band is the travel of u
after a reversal until the valve moves: ascending before it moves with rising u,
descending with falling u. Intervals are 95 %.

Recordings longer than 4096 samples are thinned out where the oscillation is slow, or
judged by up to eight windows spread over them.)";

int identify(const Options& options) {
  const Recording recording = read(options.source);
  const Analysis analysis = identify_with_progress(recording);
  if (options.json) {
    for (const std::string& note : recording.resampling.notes) complain(note);
    for (const std::string& note : analysis.notes()) complain(note);
  }
  print(options.json ? json_line(identification_json(recording, analysis))
                     : identification_text(recording, analysis));
  const Identification& result = analysis.result();
  return exit_code_for(result.verdict, result.reason);
}

}  // namespace

void add_identify(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "identify", "Tell whether the valve sticks, and how much, from u and y");
  add_recording_options(*command, options->source);
  command->add_flag("--json", options->json, "one JSON object instead of text");
  command->footer(kFooter);
  command->callback(
      [&action, options] { action = [options] { return identify(*options); }; });
}

}  // namespace workbench::cli
