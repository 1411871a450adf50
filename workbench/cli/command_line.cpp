#include "workbench/cli/command_line.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "config/gateway.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/console.hpp"
#include "workbench/cli/exit_code.hpp"
#include "workbench/cli/narrow_help.hpp"
#include "workbench/recording/input_error.hpp"

namespace workbench::cli {
namespace {

constexpr const char* kExamples = R"(
Examples:
  stickband simulate paper-example-1 --seed 1 -o loop.csv --truth loop.json
  stickband identify loop.csv            does the valve stick, and how much?
  stickband identify loop.csv --json     the same for scripts
  stickband report loop.csv -o loop.html one page with the pictures
  stickband ladder loop.csv              which physical effects are in the loop?
  stickband serve loop.csv               the same step by step, as a page
  stickband screen archive/ -o plant.html which of many loops to look at
  stickband pull --can can0 --loop 1 -o loop.csv   what a gateway has recorded
  stickband monitor bus.log --dbc plant.dbc --u LoopOP.OP --y LoopPV.PV

Recordings are CSV files with the columns t, u and y (or OP and PV), or CAN logs
written by `candump -L` together with the DBC file that explains them.

Exit codes: 0 done, 2 wrong usage, 3 bad input, 4 the data cannot answer, 130 ended by
Ctrl-C, 1 anything else. `stickband COMMAND --help` explains a command.)";

// Ends at once, wherever the work is; files appear whole or not at all.
extern "C" void interrupted(int) {
  _exit(kInterrupted);
}

void end_on_interrupt() {
  struct sigaction before {};
  const bool ignored =
      sigaction(SIGINT, nullptr, &before) == 0 && before.sa_handler == SIG_IGN;
  if (!ignored) std::signal(SIGINT, interrupted);  // nohup and `&` ignore it
}

// Letters to insert, delete or replace (Levenshtein).
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t corner = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = corner + (a[i] == b[j] ? 0 : 1);
      corner = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, corner + 1});
    }
  }
  return row.back();
}

// "; did you mean `identify`?" where the first word is nearly a command; a file means
// identify.
std::string suggestion(const CLI::App& app, std::string_view word) {
  if (word.empty() || word.front() == '-') return {};
  std::string best;
  std::size_t least = 1 + word.size() / 3;
  for (const CLI::App* command : app.get_subcommands({})) {
    const std::size_t far = distance(word, command->get_name());
    if (far > least) continue;
    least = far;
    best = command->get_name();
  }
  std::error_code ignored;
  if (best.empty() && std::filesystem::exists(word, ignored)) {
    return "; did you mean `stickband identify " + std::string(word) + "`?";
  }
  return best.empty() ? best : "; did you mean `" + best + "`?";
}

// Where a page is asked of a command that prints.
std::string html_hint(std::string_view what, const std::vector<char*>& words) {
  const auto is_page = [](const char* word) {
    return std::string_view(word).ends_with(".html");
  };
  const auto page = std::ranges::find_if(words, is_page);
  if (page == words.end() || what.find("not expected: -o") == std::string_view::npos) {
    return {};
  }
  return "; `stickband report REC -o " + std::string(*page) + "` writes HTML";
}

int dispatch(int argc, char** argv) {
  CLI::App app;
  Action action;
  describe(app, action);
  // `help COMMAND`, as other programs have it.
  std::vector<char*> words(argv, argv + argc);
  static char help[] = "--help";
  if (argc > 1 && std::string_view(argv[1]) == "help") {
    words.erase(words.begin() + 1);
    words.push_back(help);
  }
  try {
    app.parse(static_cast<int>(words.size()), words.data());
  } catch (const CLI::CallForHelp&) {
    const auto parsed = app.get_subcommands();
    print(parsed.empty() ? app.help() : parsed.front()->help("stickband"));
    return kDone;
  } catch (const CLI::CallForVersion& version) {
    print(std::string(version.what()) + '\n');
    return kDone;
  } catch (const CLI::ParseError& error) {
    const auto parsed = app.get_subcommands();
    const std::string command = parsed.empty() ? "" : ' ' + parsed.front()->get_name();
    std::string what = error.what();
    if (parsed.empty() && words.size() > 1 && words[1][0] != '-') {
      what = "no command " + quoted(words[1]) + suggestion(app, words[1]);
    }
    throw UsageError(what + html_hint(what, words) + "; see stickband" + command +
                     " --help");
  }
  return action();
}

}  // namespace

void describe(CLI::App& app, Action& action) {
  app.name("stickband");
  app.formatter(std::make_shared<NarrowHelp>());
  app.description(
      "Finds sticking control valves in recordings of controller output u and\n"
      "process output y.");
  app.set_version_flag("--version", std::string("stickband ") + STICKBAND_VERSION);
  app.footer(kExamples);
  app.require_subcommand(1);
  add_identify(app, action);
  add_oscillation(app, action);
  add_monitor(app, action);
  add_report(app, action);
  add_model(app, action);
  add_compare(app, action);
  add_explain(app, action);
  add_add(app, action);
  add_remove(app, action);
  add_ladder(app, action);
  add_serve(app, action);
  add_screen(app, action);
  add_pull(app, action);
  add_simulate(app, action);
}

int run(int argc, char** argv) {
  // A reader that goes away is reported by the write that fails.
  std::signal(SIGPIPE, SIG_IGN);
  end_on_interrupt();
  try {
    return dispatch(argc, argv);
  } catch (const UsageError& error) {
    complain(error.what());
    return kWrongUsage;
  } catch (const CannotAnswer& error) {
    return cannot_answer(error.what());
  } catch (const InputError& error) {
    complain(error.what());
    return kBadInput;
  } catch (const config::ConfigError& error) {
    complain(error.what());
    return kBadInput;
  } catch (const std::bad_alloc&) {
    complain("out of memory");
  } catch (const std::exception& error) {
    complain(error.what());
  }
  return kFailed;
}

}  // namespace workbench::cli
