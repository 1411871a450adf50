#include <CLI/CLI.hpp>
#include <memory>

#include "wire/diagnostics.hpp"
#include "wire/text.hpp"
#include "workbench/cli/can_port.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/console.hpp"
#include "workbench/cli/exit_code.hpp"
#include "workbench/cli/output_file.hpp"
#include "workbench/pull/pulled_recording.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::cli {
namespace {

struct Options {
  std::string can;
  int loop = 0;
  std::string csv;
  std::string request_id;
  std::string response_id;
  bool extended = false;
  bool history = false;
};

constexpr const char* kFooter = R"(
Examples:
  stickband pull --can can0 --loop 1 -o loop.csv
  stickband identify loop.csv
  stickband pull --can can0 --loop 1 --history -o years.csv

Reads only: nothing in the gateway changes. The recording is that of the gateway's window
at the moment of the request; t starts at 0.)";

std::uint32_t id_of(const char* option, const std::string& text, bool extended) {
  std::string_view digits = text;
  if (digits.starts_with("0x") || digits.starts_with("0X")) digits.remove_prefix(2);
  const auto id = wire::number_of<std::uint32_t>(digits, 16);
  if (!id || *id > (extended ? wire::kMaxExtendedId : wire::kMaxStandardId)) {
    throw UsageError(std::string(option) + ": expected a CAN identifier of " +
                     (extended ? "29" : "11") + " bits in hex, found '" + text + "'");
  }
  return *id;
}

wire::IsoTpSettings server_of(const Options& options) {
  wire::IsoTpSettings server;
  if (options.extended) server = wire::normal_fixed_settings();
  if (!options.request_id.empty()) {
    server.request_id = id_of("--request-id", options.request_id, options.extended);
  }
  if (!options.response_id.empty()) {
    server.response_id = id_of("--response-id", options.response_id, options.extended);
  }
  return server;
}

int pull(const Options& options) {
  expect_writable(options.csv);
  const wire::IsoTpSettings server = server_of(options);
  CanPort port(options.can, server.response_id, server.extended_ids);
  UdsClient client(port, server);
  ProgressLine line;
  const auto progress = [&line](std::size_t at, std::size_t all) {
    line.show(std::to_string(100 * at / all) + " % of " + std::to_string(all) + " bytes");
  };
  if (options.history) {
    const PulledHistory history = pull_history(client, options.loop, progress);
    write_file(options.csv, csv_of(history));
    print(history.tag + ": " + std::to_string(history.rows.size()) + " windows\n");
    return kDone;
  }
  const PulledRecording recording = pull_recording(client, options.loop, progress);
  write_file(options.csv, csv_of(recording));
  print(recording.tag + ": " + std::to_string(recording.samples.size()) +
        " samples, one every " + number(recording.header.period_us * 1e-6) + " s\n");
  return kDone;
}

}  // namespace

void add_pull(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "pull", "Fetch the recording window of a gateway's loop over CAN");
  command->add_option("--can", options->can, "the interface, e.g. can0, or slcan:PORT")
      ->required()
      ->type_name("IF");
  command->add_option("--loop", options->loop, "its number in the gateway, 1 to 31")
      ->required()
      ->check(CLI::Range(1, wire::kMostLoops))
      ->type_name("N");
  command->add_option("-o,--output", options->csv, "the recording, CSV")
      ->required()
      ->type_name("REC.csv");
  command->add_option("--request-id", options->request_id, "of the gateway; 7E0")
      ->type_name("HEX");
  command->add_option("--response-id", options->response_id, "of the gateway; 7E8")
      ->type_name("HEX");
  command->add_flag("--history", options->history,
                    "what its windows said, for years, instead of the recording");
  command->add_flag("--extended", options->extended, "29 bits: 18DA10F1 and 18DAF110");
  runs(*command, action, options, pull, kFooter);
}

}  // namespace workbench::cli
