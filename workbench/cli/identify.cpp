#include <CLI/CLI.hpp>
#include <memory>

#include "workbench/analysis/analysis.hpp"
#include "workbench/analysis/identification_json.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/console.hpp"
#include "workbench/cli/identification_text.hpp"
#include "workbench/cli/recording_options.hpp"
#include "workbench/model/base/one_loop.hpp"

namespace workbench::cli {
namespace {

struct Options {
  RecordingSource source;
  std::vector<std::string> more;  // further recordings of the same loop
  bool json = false;
};

constexpr const char* kFooter = R"(
Examples:
  stickband identify loop.csv
  stickband identify loop.csv --ts 0.5 --json
  stickband identify monday.csv tuesday.csv
  stickband identify export.csv --u FIC101.OP --y FIC101.PV
  stickband identify bus.log --dbc plant.dbc --u LoopOP.OP --y LoopPV.PV

Verdicts: stiction, backlash, no_stiction, undecided, bad_data. With the last two the
exit code is 4, and stderr says what data would tell. The stick band is the travel of u
after a reversal until the valve moves: ascending before it moves with rising u,
descending with falling u. Intervals are 95 %.

Recordings longer than 4096 samples are thinned out where the oscillation is slow, or
judged by up to eight windows spread over them. Several recordings of one loop, in the
same units, are judged together: one valve has to serve them all. Files with one signal
each, FIC101.OP.csv FIC101.PV.csv, are one recording.)";

int identify(const Options& options) {
  complain_about_loads(options.source);
  std::vector<std::string> paths{options.source.path};
  paths.insert(paths.end(), options.more.begin(), options.more.end());
  std::vector<Recording> recordings;
  for (const RecordingSource& one : sources_of(options.source, paths)) {
    recordings.push_back(read(one));
  }
  check_one_loop(recordings);
  const std::vector<std::string> overlaps = overlaps_of(recordings);
  Recording recording = recordings.front();
  for (std::size_t i = 1; i < recordings.size(); ++i) {
    for (const std::string& note : recordings[i].resampling.notes) {
      recording.resampling.notes.push_back(recordings[i].name + ": " + note);
    }
  }
  for (const std::string& note : overlaps) recording.resampling.notes.push_back(note);
  const Analysis analysis = identify_with_progress(std::move(recordings), options.source);
  if (options.json) {
    for (const std::string& note : recording.resampling.notes) complain(note);
    for (const std::string& note : analysis.notes()) complain(note);
  }
  print(options.json ? json_line(identification_json(recording, analysis))
                     : identification_text(recording, analysis));
  const Identification& result = analysis.result();
  return exit_code_for(result.verdict, result.reason, !options.json);
}

}  // namespace

void add_identify(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "identify", "Tell whether the valve sticks, and how much, from u and y");
  add_recording_options(*command, options->source);
  command->add_option("MORE", options->more,
                      "further recordings of the same loop, judged together");
  command->add_flag("--json", options->json, "one JSON object instead of text");
  runs(*command, action, options, identify, kFooter);
}

}  // namespace workbench::cli
