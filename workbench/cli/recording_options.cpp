#include "workbench/cli/recording_options.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <string>

#include "workbench/cli/console.hpp"
#include "workbench/cli/exit_code.hpp"
#include "workbench/recording/cell_reader.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/recording/time_unit.hpp"

namespace workbench::cli {
namespace {

std::string positive_number(const std::string& text) {
  double value = 0;
  if (!CLI::detail::lexical_cast(text, value) || !std::isfinite(value) || value <= 0) {
    return "expected a positive number of seconds, found '" + text + "'";
  }
  return {};
}

std::string finite_number(const std::string& text) {
  double value = 0;
  if (!CLI::detail::lexical_cast(text, value) || !std::isfinite(value)) {
    return "expected a number, found '" + text + "'";
  }
  return {};
}

void add_writing_options(CLI::App& command, RecordingSource& source) {
  add_date_order(command, source.date_order,
                 "which number of 03/04/2026 is the day: dmy, mdy or ymd")
      ->group("Columns");
  add_decimal(
      command, source.decimal,
      "the decimal mark of numbers as 1.234: point or comma; the other one groups "
      "thousands")
      ->group("Columns");
  command
      .add_option("--sheet", source.sheet,
                  "of an Excel or OpenDocument workbook, where several hold the columns")
      ->type_name("NAME")
      ->group("Columns");
}

}  // namespace

CLI::Option* add_date_order(CLI::App& command, std::optional<DateOrder>& order,
                            const std::string& help) {
  return command
      .add_option_function<std::string>(
          "--date-order",
          [&order](const std::string& text) { order = date_order_named(text); }, help)
      ->type_name("ORDER")
      ->check(CLI::IsMember({"dmy", "mdy", "ymd"}));
}

CLI::Option* add_decimal(CLI::App& command, std::optional<char>& decimal,
                         const std::string& help) {
  return command
      .add_option_function<std::string>(
          "--decimal",
          [&decimal](const std::string& text) { decimal = text == "comma" ? ',' : '.'; },
          help)
      ->type_name("MARK")
      ->check(CLI::IsMember({"point", "comma"}));
}

void add_recording_options(CLI::App& command, RecordingSource& source, bool required) {
  command
      .add_option("REC", source.path,
                  "CSV or historian export with u (OP) and y (PV), or a candump log "
                  "with --dbc")
      ->required(required);
  command
      .add_option("--ts", source.ts,
                  "sample period in s, or with its unit: 500ms; replaces the time column")
      ->type_name("SECONDS")
      ->transform(CLI::Validator(
          [](std::string& text) {
            text = in_seconds(text);
            return std::string();
          },
          ""))
      ->check(CLI::Validator(positive_number, ""));
  command
      .add_option("--u-before", source.u_before,
                  "where u rested before the first row: for a step test that begins with "
                  "its step")
      ->type_name("VALUE")
      ->check(CLI::Validator(finite_number, ""));
  const auto column = [&command](const char* name, std::string& target,
                                 const char* text) {
    command.add_option(name, target, text)->type_name("COLUMN")->group("Columns");
  };
  column("--u", source.names.u,
         "controller output: name of its column or tag, or #3 for the third; with --dbc "
         "MESSAGE.SIGNAL");
  column("--y", source.names.y, "process output, likewise");
  column("--sp", source.names.sp, "setpoint, likewise");
  column("--x", source.names.x, "valve position, likewise");
  column("--time", source.names.time, "time");
  command
      .add_option("--load", source.names.loads,
                  "a further measured signal, repeatable; all: every one")
      ->type_name("COLUMN")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->group("Columns");
  add_writing_options(command, source);
  const auto can = [&command](const char* name, std::string& target, const char* text) {
    command.add_option(name, target, text)->type_name("FILE")->group("CAN log");
  };
  can("--dbc", source.dbc, "REC is a candump log; FILE explains its frames");
  can("--config", source.config,
      "instead of --dbc and signals: the gateway's own TOML configuration");
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

void complain_about_loads(const RecordingSource& source) {
  if (source.names.loads.empty()) return;
  complain(
      "the verdict is from u and y alone: no column of --load takes part. "
      "stickband explain weighs each of them");
}

std::string identifying(int window, int windows) {
  return windows == 1 ? "identifying"
                      : "identifying window " + std::to_string(window) + " of " +
                            std::to_string(windows);
}

Analysis identify_with_progress(std::vector<Recording> recordings,
                                const RecordingSource& source) {
  ProgressLine line;
  Analysis analysis(std::move(recordings), [&line](int window, int windows) {
    line.show(identifying(window, windows));
  });
  if (const auto span = configured_span(source)) {
    analysis.refer_to((*span)[1] - (*span)[0]);
  }
  return analysis;
}

}  // namespace workbench::cli
