// How a recording is read, as words of a command line.
#pragma once

#include <optional>
#include <string>

#include "workbench/recording/csv.hpp"
#include "workbench/recording/source.hpp"

namespace workbench {

/// A path as a word that no command takes for an option.
[[nodiscard]] std::string file_word(const std::string& path);

/// " --u FIC101.OP --y FIC101.PV --ts 0.5": each with a blank before it; empty where
/// nothing is asked for. `u_before`: where u rested before the first row
/// (rest_before.hpp).
[[nodiscard]] std::string option_words(const CsvOptions& options,
                                       std::optional<double> u_before = {});
/// The same of whatever the command line named, of CAN logs, too.
[[nodiscard]] std::string option_words(const RecordingSource& source);

}  // namespace workbench
