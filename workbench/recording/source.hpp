// Whatever the command line names as a recording.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "workbench/recording/csv.hpp"
#include "workbench/recording/recording.hpp"

namespace workbench {

/// The options of every command that takes REC. Of those of CSV files a candump log
/// takes --ts and, as MESSAGE.SIGNAL, --u, --y, --sp and --x.
struct RecordingSource : CsvOptions {
  std::string path;                 ///< REC
  std::vector<std::string> beside;  ///< where REC holds one signal: files of the others
  std::string dbc;                  ///< --dbc FILE: REC is a candump log
  std::string config;       ///< --config FILE: the gateway's own, instead of --dbc
  std::optional<int> loop;  ///< --loop N: which of its loops; nothing: the only one
  std::optional<double> u_before;  ///< --u-before: u rested there (rest_before.hpp)
};

/// What `paths` mean, each read as `like` says: a recording each, or where every one
/// holds a single signal (tag_file.hpp) all together one.
[[nodiscard]] std::vector<RecordingSource> sources_of(
    const RecordingSource& like, const std::vector<std::string>& paths);

/// Reads a CSV file or any export of a historian (csv.hpp), or with `dbc` or `config` a
/// candump log. Throws InputError for bad input, a candump log without `dbc` included,
/// config::ConfigError for a bad configuration, and std::invalid_argument for options
/// that do not go together or name no column (wrong usage).
[[nodiscard]] Recording read_recording(const RecordingSource& source);

/// The span of u, in its unit, of the loop that `source.config` describes: what the
/// gateway's percentages refer to. Nothing without `config`. Throws as read_recording().
[[nodiscard]] std::optional<std::array<double, 2>> configured_span(
    const RecordingSource& source);

}  // namespace workbench
