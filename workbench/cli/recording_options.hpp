// The options of every command that reads a recording.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workbench/analysis/analysis.hpp"
#include "workbench/recording/recording.hpp"
#include "workbench/recording/source.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace workbench::cli {

/// Adds REC, --ts, --time, --u, --y, --sp, --x, --load, --date-order, --decimal, --sheet,
/// --dbc, --config and --loop, stored in `source`, which must outlive the parsing. REC
/// may be left out where it is not `required`.
void add_recording_options(CLI::App& command, RecordingSource& source,
                           bool required = true);

/// --date-order and --decimal: how files write what can be read in two ways.
CLI::Option* add_date_order(CLI::App& command, std::optional<DateOrder>& order,
                            const std::string& help);
CLI::Option* add_decimal(CLI::App& command, std::optional<char>& decimal,
                         const std::string& help);

/// Reads it. Throws InputError, or UsageError where options contradict each other.
[[nodiscard]] Recording read(const RecordingSource& source);

/// Where the verdict alone is asked for, to which measured loads say nothing.
void complain_about_loads(const RecordingSource& source);

/// What a progress line says of a window that is being identified.
[[nodiscard]] std::string identifying(int window, int windows);
/// Identifies them as one loop, with progress on a terminal. Percentages refer to the
/// span that the configuration of `source` states, if any.
[[nodiscard]] Analysis identify_with_progress(std::vector<Recording> recordings,
                                              const RecordingSource& source);

}  // namespace workbench::cli
