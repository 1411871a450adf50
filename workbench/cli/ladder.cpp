#include "workbench/model/search/ladder.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "workbench/analysis/identification_json.hpp"
#include "workbench/analysis/wording.hpp"
#include "workbench/cli/candidates_text.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/console.hpp"
#include "workbench/cli/exit_code.hpp"
#include "workbench/cli/ladder_steps.hpp"
#include "workbench/cli/left_behind.hpp"
#include "workbench/cli/model_options.hpp"
#include "workbench/cli/next_file.hpp"
#include "workbench/cli/parameter_table.hpp"
#include "workbench/cli/unused_columns.hpp"
#include "workbench/cli/verdict_beside.hpp"
#include "workbench/model/tell/cautions.hpp"
#include "workbench/model/tell/explanation_json.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::cli {
namespace {

constexpr const char* kFooter = R"(
Examples:
  stickband ladder loop.csv
  stickband ladder loop.csv -o m.json --json
  stickband ladder valve.csv --output x
  stickband ladder monday.csv tuesday.csv --validate friday.csv

Starts from a first-order process and adds one effect after another as long as samples
that were not fitted agree.)";

// What it came to can be what another one starts from.
std::string why_it_ended(const LadderResult& result, bool time_was_up,
                         const SearchSoFar& so_far) {
  // Each effect was tried, and none accepted: the limit only kept it from trying pairs.
  const bool is_at_end =
      !time_was_up && result.last.complete && result.last.best() == nullptr;
  std::string why = is_at_end
                        ? "No further effect is accepted alone; not all pairs of effects "
                          "were tried, for the search has a limit of its own."
                        : ended_early(time_was_up, "model");
  // What nothing was added to would end where it began.
  const std::string command = search_on(so_far);
  if (time_was_up || command.empty()) return wrapped(why, 0);
  why.back() = ';';
  return wrapped(why + (is_at_end ? " to try them:" : " go on from it:"), 0) + "\n  " +
         command;
}

// Effects that left no trace, less those that a step may be instead.
std::vector<Candidate> never_exercised(const LadderResult& result) {
  std::vector<Candidate> idle;
  for (const Candidate& c : result.last.candidates) {
    const bool may_be = std::ranges::any_of(result.steps, [&](const LadderStep& step) {
      const std::vector<std::string>& group = step.indistinguishable_from;
      return std::ranges::find(group, c.effect) != group.end();
    });
    if (c.status == CandidateStatus::kNotExcited && !may_be) idle.push_back(c);
  }
  return idle;
}

std::string what_is_left(const LadderResult& result,
                         const std::optional<ValveVerdict>& verdict,
                         const SearchSoFar& so_far) {
  if (result.explained) return noise_is_left("Explained", verdict);
  return what_comes_closest("Not explained: what is left is more than noise.",
                            result.last, so_far);
}

// "584 samples, one every 1 s"; of several recordings those that judge apart.
std::string samples_text(const Recording& recording) {
  std::size_t judging = 0;
  for (const Piece& piece : recording.pieces) {
    if (piece.judges) judging += piece.last - piece.first;
  }
  return std::to_string(recording.size() - judging) + " samples, one every " +
         number(recording.period_s) + " s" +
         (judging > 0 ? "; " + std::to_string(judging) + " of other recordings judge"
                      : std::string());
}

std::string ladder_text(const LadderResult& result, const Recording& recording,
                        const std::optional<ValveVerdict>& verdict, bool time_was_up,
                        const SearchSoFar& so_far, const std::string& kept) {
  const std::string mind = caution_text(result.model, recording, result.quality,
                                        result.last.left_to_controller);
  std::string text = recording.name + ": " + samples_text(recording) + "\n\n";
  // Whose model this is, is to be known before its steps are read.
  if (result.last.left_to_controller) text += mind + '\n';
  text += "  step                            error     validation\n" +
          steps_text(result.steps, so_far.begun_with);
  if (result.searched) {
    text += '\n' + searched_text(*result.searched,
                                 "the errors above. The fit below is "
                                 "that of all samples.");
  }
  text += "\nFit " + fixed(result.quality.fit_percent, 1) + " %; noise about " +
          number(result.last.noise_rmse, 4) + "\n" +
          recordings_table(result.quality.recordings) +
          (!result.complete ? why_it_ended(result, time_was_up, so_far) + '\n'
           : tells_nothing(result.model, result.quality)
               ? ""
               : what_is_left(result, verdict, so_far) + '\n');
  const std::string said = verdict_text(verdict);
  if (!said.empty()) text += '\n' + said.substr(0, said.size() - 1);
  for (const EffectTerm& term : result.model.effects) {
    text += '\n' + term.effect + '\n' + effect_table(term, 2);
  }
  text += "\nprocess\n" + parameter_table(result.model.process, 2);
  if (!mind.empty() && !result.last.left_to_controller) text += '\n' + mind;
  const std::string idle = candidates_text(never_exercised(result));
  if (!idle.empty()) text += "\nNever exercised by this recording:\n" + idle;
  return text + '\n' + kept;
}

int climb(const ModelOptions& options) {
  refuse_to_replace_inputs(options);
  LadderOptions ladder;
  ladder.output = output_of(options, Column::y);
  ladder.with = effects_of(options);
  ReadRecordings read = read_for(options, ladder.output, ladder.with);
  const Recording& recording = read.joined;
  LadderResult result;
  std::optional<ValveVerdict> verdict;
  bool time_was_up = false;
  {
    const Work work(limits_of(options));
    ladder.work = &work;
    ProgressLine line;
    VerdictBeside beside(options, std::move(read.fitted), ladder.output, line);
    ladder.identified = beside.identified();
    ladder.progress = [&line](auto... tried) { line.trying(tried...); };
    result = run_ladder(recording, ladder);
    verdict = beside.of(work, result.model, result.last.best());
    time_was_up = work.out_of_time();
  }
  complain_about_unlike(recording, ladder.output, result.quality.recordings);
  complain_about_left_behind(result.model, recording);
  const UnusedColumns unused = complain_about_unused(read, result.model);
  const std::string kept = saved(result.model, options.target);
  nlohmann::ordered_json json = ladder_json(result);
  json["identify"] = verdict_json(verdict);
  const SearchSoFar so_far{ladder_words(options, ladder.output),
                           result.model.effect_codes(), ladder.with,
                           !unused.names.empty(), next_file(options.target)};
  print(options.json
            ? json_line(json)
            : ladder_text(result, recording, verdict, time_was_up, so_far, kept));
  return kDone;
}

}  // namespace

void add_ladder(CLI::App& app, Action& action) {
  const auto options = std::make_shared<ModelOptions>();
  CLI::App* command = app.add_subcommand(
      "ladder", "Explain and add until nothing more is accepted: watch the error fall");
  add_model_options(*command, *options);
  add_target(*command, *options);
  add_with(*command, *options);
  add_work(*command, *options, true);
  runs(*command, action, options, climb, kFooter);
}

}  // namespace workbench::cli
