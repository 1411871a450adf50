// Whatever the command line names as a recording.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workbench/recording/input_error.hpp"
#include "workbench/recording/recording.hpp"

namespace workbench {

/// The options of every command that takes REC.
struct RecordingSource {
  std::string path;          ///< REC
  std::optional<double> ts;  ///< --ts, s
  std::string dbc;           ///< --dbc FILE: REC is a candump log
  std::string u;             ///< --u MESSAGE.SIGNAL, with --dbc only; likewise:
  std::string y;
  std::string sp;
  std::string x;
  std::string config;       ///< --config FILE: the gateway's own, instead of --dbc
  std::optional<int> loop;  ///< --loop N: which of its loops; nothing: the only one
  std::vector<Column> required = {Column::u, Column::y};  ///< columns it must have
};

/// Reads a CSV file, or with `dbc` or `config` a candump log. Throws InputError for bad
/// input, a candump log without `dbc` included, config::ConfigError for a bad
/// configuration, and std::invalid_argument for options that do not go together (wrong
/// usage).
[[nodiscard]] Recording read_recording(const RecordingSource& source);

}  // namespace workbench
