#include "workbench/cli/recording_options.hpp"

#include <CLI/CLI.hpp>
#include <cmath>

#include "workbench/cli/console.hpp"
#include "workbench/cli/exit_code.hpp"

namespace workbench::cli {
namespace {

std::string positive_number(const std::string& text) {
  double value = 0;
  if (!CLI::detail::lexical_cast(text, value) || !std::isfinite(value) || value <= 0) {
    return "expected a positive number of seconds, found '" + text + "'";
  }
  return {};
}

}  // namespace

void add_recording_options(CLI::App& command, RecordingSource& source, bool required) {
  command
      .add_option("REC", source.path,
                  "CSV with columns t, u, y (and sp, x), or a candump log with --dbc")
      ->required(required);
  command.add_option("--ts", source.ts, "sample period in s; replaces column t")
      ->type_name("SECONDS")
      ->check(CLI::Validator(positive_number, ""));
  const auto can = [&command](const char* name, std::string& target, const char* type,
                              const char* text) {
    command.add_option(name, target, text)->type_name(type)->group("CAN log");
  };
  can("--dbc", source.dbc, "FILE", "REC is a candump log; FILE explains its frames");
  can("--u", source.u, "MESSAGE.SIGNAL", "controller output");
  can("--y", source.y, "MESSAGE.SIGNAL", "process output");
  can("--sp", source.sp, "MESSAGE.SIGNAL", "setpoint");
  can("--x", source.x, "MESSAGE.SIGNAL", "valve position");
  can("--config", source.config, "FILE",
      "instead of these: the gateway's own TOML configuration");
  command.add_option("--loop", source.loop, "with --config: which of its loops")
      ->type_name("N")
      ->group("CAN log");
}

Recording read(const RecordingSource& source) {
  try {
    return read_recording(source);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

Analysis identify_with_progress(std::vector<Recording> recordings) {
  ProgressLine line;
  return Analysis(std::move(recordings), [&line](int window, int windows) {
    line.show(windows == 1 ? std::string("identifying")
                           : "identifying window " + std::to_string(window) + " of " +
                                 std::to_string(windows));
  });
}

}  // namespace workbench::cli
