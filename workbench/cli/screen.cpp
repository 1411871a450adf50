#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>

#include "workbench/analysis/identification_json.hpp"
#include "workbench/analysis/wording.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/console.hpp"
#include "workbench/cli/exit_code.hpp"
#include "workbench/cli/model_options.hpp"
#include "workbench/cli/output_file.hpp"
#include "workbench/cli/recording_options.hpp"
#include "workbench/screen/result_files.hpp"
#include "workbench/screen/screening.hpp"

namespace workbench::cli {
namespace {

struct Options {
  std::vector<std::string> paths;
  std::string pairs;
  std::vector<std::string> outputs;
  std::string journal;
  ScreeningOptions screening;
  bool json = false;
  bool afresh = false;
  bool apart = false;
  bool plan = false;
};

constexpr const char* kFooter = R"(
Examples:
  stickband screen archive/ -o plant.html
  stickband screen 'archive/2024-*/FIC*.csv' --json > plant.jsonl
  stickband screen export.csv --pairs '*.OUT/*.PV/*.SP' -o plant.html -o p.csv
  stickband screen @files.txt -o plant.sqlite --threads 16

PATH is a file, a folder, a pattern, or @LIST. Tables and long exports with many tags
are taken apart, files with one tag each put together; tags are paired by their usual
names, by rules u/y/sp/x with * for the tag, or by a CSV file with the columns loop, u,
y. -o goes by its ending: .html, .jsonl, .csv, .sqlite or .db; it may be given several
times.

Beside the first output a journal (NAME.journal) remembers finished loops: the same
command again goes on where it was stopped. Ctrl-C leaves a result of what was done; a
second one ends at once. A file that cannot be read is a line with its error; exit code 3
only where none could be read.)";

// Asked by the work; a signal may only set this.
std::atomic<bool> stopped{false};
std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void stop_screening(int) {
  if (interrupted.exchange(true)) _exit(kInterrupted);
  stopped = true;
}

class ShownProgress {
 public:
  void show(const ScreeningProgress& at) {
    const auto now = std::chrono::steady_clock::now();
    if (at.phase != phase_ || at.at != at_) {
      phase_ = at.phase;
      at_ = at.at;
      begin_ = now;
    }
    const double spent = std::chrono::duration<double>(now - begin_).count();
    const double share =
        at.all > 0 ? static_cast<double>(at.done) / static_cast<double>(at.all) : 0;
    std::string text;
    switch (at.phase) {
      case ScreeningProgress::Phase::kLooking:
        text = "looking into file " + std::to_string(at.done) + " of " +
               std::to_string(at.all);
        break;
      case ScreeningProgress::Phase::kSplitting:
        text = "taking apart " + at.at.substr(at.at.find_last_of('/') + 1) + ", " +
               fixed(100 * share, 0) + " %";
        break;
      case ScreeningProgress::Phase::kIdentifying:
        text = "loop " + std::to_string(at.done) + " of " + std::to_string(at.all);
        break;
    }
    if (spent > 1 && share > 0) {
      if (at.phase == ScreeningProgress::Phase::kIdentifying) {
        text += ", " + fixed(static_cast<double>(at.done) / spent, 1) + " a second";
      }
      text += ", " + duration(spent * (1 - share) / share) + " left";
    }
    line_.show(text);
  }

 private:
  ProgressLine line_;
  ScreeningProgress::Phase phase_ = ScreeningProgress::Phase::kLooking;
  std::string at_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

// A line for each of the most suspicious loops.
std::string suspects(const Screening& result) {
  std::string text;
  int shown = 0;
  for (const ScreenedLoop& loop : result.loops) {
    if (!loop.error.empty()) break;
    if (loop.suspicion < 0.5) continue;
    if (++shown > 20) break;
    std::string line = loop.loop;
    line.resize(std::max<std::size_t>(line.size(), 24), ' ');
    text += "  " + line + ' ' + loop.verdict;
    const auto& [up, down] = loop.stick_band;
    const bool is_down = !up.known || (down.known && up.value < down.value);
    const EstimateText band = text_of(is_down ? down : up);
    if (up.known || down.known) {
      text += ", band " + band.value + " (" + band.interval + ')' +
              (loop.unit.empty() ? "" : ' ' + loop.unit);
    }
    if (loop.group > 0) {
      text += ", group " + std::to_string(loop.group) + (loop.leads ? ", leads" : "");
    }
    text += '\n';
  }
  return text;
}

// A command on a line of its own, to be copied.
std::string not_read(const ScreenedLoop& loop) {
  const std::string& error = loop.error;
  const std::size_t command = error.find("stickband identify ");
  const bool named = error.find(loop.loop) != std::string::npos;
  std::string text = wrapped(
      "not read: " + (named ? "" : loop.loop + ": ") + error.substr(0, command), 2);
  if (command != std::string::npos) text += "\n  " + error.substr(command);
  return text;
}

std::string passed_over(const Screening& result) {
  const std::size_t count = result.passed_over.size();
  return std::to_string(count) + (count == 1 ? " file" : " files") +
         " of other kinds passed over: " + names_of_some(result.passed_over);
}

// `listed`: a list named the loops.
std::string summary(const Screening& result, const std::vector<std::string>& outputs,
                    bool listed) {
  std::map<std::string, int> verdicts;
  int groups = 0;
  for (const ScreenedLoop& loop : result.loops) {
    if (loop.error.empty()) ++verdicts[loop.verdict];
    groups = std::max(groups, loop.group);
  }
  std::string text = std::to_string(result.loops.size()) +
                     (result.loops.size() == 1 ? " loop:" : " loops:");
  for (const auto& [verdict, count] : verdicts) {
    text += ' ' + std::to_string(count) + ' ' + verdict + ',';
  }
  const std::size_t bad = result.loops.size() - result.readable;
  text += ' ' + std::to_string(bad) + " not read; " + std::to_string(groups) +
          (groups == 1 ? " group" : " groups") + '\n';
  text += suspects(result);
  constexpr std::size_t kMostTold = 5;
  std::size_t told = 0;
  for (const ScreenedLoop& loop : result.loops) {
    if (loop.error.empty() || ++told > kMostTold) continue;
    text += not_read(loop) + '\n';
  }
  if (told > kMostTold) {
    text += "  and " + std::to_string(told - kMostTold) + " more: the results say why\n";
  }
  if (!result.passed_over.empty()) text += "  " + passed_over(result) + '\n';
  if (!result.unpaired.empty()) {
    text += std::to_string(result.unpaired.size()) + " tags belong to no loop:";
    for (std::size_t i = 0; i < std::min<std::size_t>(result.unpaired.size(), 8); ++i) {
      text += "\n  " + result.unpaired[i];
    }
    text += result.unpaired.size() > 8 ? "\n  ...\n" : "\n";
    if (listed) {
      text +=
          "  (a list of --pairs names all loops; rules as *.OP/*.PV add to the usual "
          "names)\n";
    }
  }
  for (const std::string& path : outputs) text += "written: " + path + '\n';
  return text;
}

int tell_plan(const ScreeningPlan& plan) {
  for (const IndependentFiles& set : plan.sets) {
    print(json_line({{"files", set.files}, {"bytes", set.bytes}, {"loops", set.loops}}));
  }
  for (const PathProblem& problem : plan.problems) {
    complain(problem.path + ": " + problem.what);
  }
  return plan.sets.empty() ? kBadInput : kDone;
}

int screen_paths(Options options) {
  ScreeningOptions& screening = options.screening;
  try {
    if (!options.pairs.empty()) screening.read.pairs = PairRules::parse(options.pairs);
    for (const std::string& path : options.outputs) {
      (void)kind_of_result(path);
      for (const std::string& input : options.paths) refuse_to_replace(input, path);
      expect_writable(path);
    }
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  screening.pool = !options.apart;
  screening.journal = options.journal;
  if (screening.journal.empty() && !options.outputs.empty()) {
    screening.journal = options.outputs.front() + ".journal";
  }
  if (options.plan) {
    screening.journal.clear();
    return tell_plan(plan_screening(options.paths, screening));
  }
  std::error_code ignored;
  if (options.afresh) std::filesystem::remove(screening.journal, ignored);
  std::signal(SIGINT, stop_screening);
  Screening result;
  {
    ShownProgress shown;
    result = screen(options.paths, screening, stopped,
                    [&shown](const ScreeningProgress& at) { shown.show(at); });
  }
  for (const std::string& path : options.outputs) {
    write_result(result, path, [](const std::string& to, std::string_view text) {
      write_file(to, text);
    });
  }
  if (options.json) {
    for (const ScreenedLoop& loop : result.loops) print(json_line(json_of(loop)));
    for (const std::string& tag : result.unpaired) complain("of no loop: " + tag);
    if (!result.passed_over.empty()) complain(passed_over(result));
  } else {
    print(summary(result, options.outputs, !screening.read.pairs.list.empty()));
  }
  if (result.resumed > 0) {
    complain(std::to_string(result.resumed) + " loops were finished before (" +
             screening.journal + ')');
  }
  if (!result.complete) {
    complain("stopped: " +
             (result.left_out > 0 ? std::to_string(result.left_out) + " loops"
                                  : std::string("not all tables")) +
             " were not reached" +
             (screening.journal.empty() ? "" : "; the same command goes on from here"));
    return interrupted ? kInterrupted : kDone;
  }
  if (options.journal.empty()) std::filesystem::remove(screening.journal, ignored);
  return result.readable > 0 ? kDone : kBadInput;
}

}  // namespace

void add_screen(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "screen", "Screen an archive: which of many loops have a valve that sticks");
  command->add_option("PATH", options->paths, "files, folders, patterns, or @LIST")
      ->required();
  command
      ->add_option("--pairs", options->pairs,
                   "which tags make a loop: rules, or a CSV file with loop, u, y")
      ->type_name("RULES");
  command
      ->add_option("-o,--output", options->outputs,
                   "result: .html, .jsonl, .csv, .sqlite; repeatable")
      ->type_name("FILE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_flag("--json", options->json, "one JSON object a loop on standard output");
  command->add_option("--threads", options->screening.threads, "default: all processors")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  command
      ->add_option("--within", options->screening.within_s,
                   "begin no loop after so many seconds; the same command goes on")
      ->type_name("SECONDS")
      ->check(CLI::PositiveNumber);
  command->add_option("--ts", options->screening.read.ts, "sample period of all files, s")
      ->type_name("SECONDS")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--time", options->screening.read.names.time,
                   "column of times of all files")
      ->type_name("COLUMN");
  add_date_order(*command, options->screening.read.date_order,
                 "of 03/04/2026: dmy, mdy, ymd");
  add_decimal(*command, options->screening.read.decimal, "of 1.234: point or comma");
  command
      ->add_option("--scratch", options->screening.scratch,
                   "folder for temporary files, as large as the tables with many loops")
      ->type_name("FOLDER");
  command
      ->add_option("--journal", options->journal,
                   "file that remembers finished loops; kept at the end")
      ->type_name("FILE");
  command->add_flag("--afresh", options->afresh, "forget what the journal remembers");
  command->add_flag("--apart", options->apart,
                    "each file is a loop of its own, whatever its name");
  command->add_flag("--same-clock", options->screening.same_clock,
                    "times without dates count from one instant in all files");
  command->add_flag("--plan", options->plan,
                    "only name the sets of files that can be screened apart, one a line");
  runs(*command, action, options, screen_paths, kFooter);
}

}  // namespace workbench::cli
