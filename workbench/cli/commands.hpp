// The commands of `stickband`, one file each.
#pragma once

#include <functional>
#include <memory>

namespace CLI {
class App;
}

namespace workbench::cli {

/// What the parsed command line asks for; returns the exit code.
using Action = std::function<int()>;

/// Ends the description of a command, a CLI::App: its action is run(*options).
template <class Command, class Options, class Run>
void runs(Command& command, Action& action, std::shared_ptr<Options> options, Run run,
          const char* footer) {
  command.footer(footer);
  command.callback(
      [&action, options, run] { action = [options, run] { return run(*options); }; });
}

/// The whole command line: name, texts and all commands; both must outlive the parsing.
void describe(CLI::App& app, Action& action);

/// Each adds one command to `app`. Parsing that command sets `action`, which outlives
/// the parsing; both must outlive `app`.
void add_identify(CLI::App& app, Action& action);
void add_oscillation(CLI::App& app, Action& action);
void add_monitor(CLI::App& app, Action& action);
void add_report(CLI::App& app, Action& action);
void add_model(CLI::App& app, Action& action);
void add_compare(CLI::App& app, Action& action);
void add_explain(CLI::App& app, Action& action);
void add_add(CLI::App& app, Action& action);
void add_remove(CLI::App& app, Action& action);
void add_ladder(CLI::App& app, Action& action);
void add_serve(CLI::App& app, Action& action);
void add_screen(CLI::App& app, Action& action);
void add_pull(CLI::App& app, Action& action);
void add_simulate(CLI::App& app, Action& action);

}  // namespace workbench::cli
