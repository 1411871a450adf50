#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <memory>
#include <optional>
#include <thread>

#include "workbench/cli/commands.hpp"
#include "workbench/cli/console.hpp"
#include "workbench/cli/exit_code.hpp"
#include "workbench/cli/model_options.hpp"
#include "workbench/cli/recording_options.hpp"
#include "workbench/recording/option_words.hpp"
#include "workbench/serve/server.hpp"

namespace workbench::cli {
namespace {

struct Options : ModelOptions {
  std::optional<int> port;
};

constexpr const char* kFooter = R"(
Examples:
  stickband serve loop.csv
  stickband serve valve.csv --output x --port 8080
  stickband serve                        open or drop a recording in the page

Prints the address of the page; Ctrl-C ends it. The page answers this machine only.
Without --port the first free port from 8316 on is taken; 0 takes any that is free.
What the page shows is there for scripts, too, under /api (workbench/serve/api.hpp).)";

// Ends the server at the first Ctrl-C, and the program at once at the second.
class Interruption {
 public:
  // Before any other thread starts, so that the signals come here.
  Interruption() {
    sigemptyset(&signals_);
    for (const int s : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&signals_, s);
    pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
  }
  ~Interruption() {
    done_ = true;
    if (!thread_.joinable()) return;
    pthread_kill(thread_.native_handle(), SIGTERM);
    thread_.join();
  }
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  void ends(PageServer& server) {
    thread_ = std::thread([this, &server] {
      for (int signal = 0, count = 0; sigwait(&signals_, &signal) == 0 && !done_;) {
        if (++count > 1) _exit(128 + signal);
        server.stop();
      }
    });
  }

 private:
  sigset_t signals_;
  std::atomic<bool> done_ = false;
  std::thread thread_;
};

int serve(const Options& options) {
  const Column output = output_of(options, Column::y);
  std::optional<Recording> recording;
  const RecordingSource& source = options.source;
  const std::string words = option_words(source);
  if (source.path.empty() && !(words + options.output).empty()) {
    throw UsageError(
        "--ts, --output and the options of columns and CAN logs go with REC: "
        "stickband serve REC --ts SECONDS");
  }
  // As it is: the page marks its gaps.
  if (!source.path.empty()) {
    recording = std::move(recordings_for(options, output).front());
    for (const std::string& note : recording->resampling.notes) complain(note);
  }
  Interruption interruption;
  Session session;
  if (recording)
    session.open(std::move(*recording), output, file_word(source.path) + words);
  PageServer server(session, options.port);
  print("Stickband is at http://127.0.0.1:" + std::to_string(server.port()) +
        "/\nCtrl-C ends it.\n");
  interruption.ends(server);
  if (!server.run()) throw PortError("the server ended; start it again");
  return kDone;
}

}  // namespace

void add_serve(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "serve", "Show the workbench as an interactive page on 127.0.0.1");
  add_recording_options(*command, options->source, false);
  command->add_option("--output", options->output, "what is modelled: y, or x")
      ->type_name("y|x")
      ->check(CLI::IsMember({"y", "x"}));
  command->add_option("--port", options->port, "port of the page")
      ->type_name("N")
      ->check(CLI::Range(0, 65535));
  runs(*command, action, options, serve, kFooter);
}

}  // namespace workbench::cli
