// What was done in the page, as lines for a shell.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workbench/recording/csv.hpp"
#include "workbench/serve/session.hpp"

namespace workbench {

/// A file with the options that read it: "export.csv --u FIC101.OP --y FIC101.PV".
/// `u_before`: where u rested before its first row (rest_before.hpp).
[[nodiscard]] std::string source_words(const std::string& path, const CsvOptions& options,
                                       std::optional<double> u_before = {});

/// One command a step: identify, then the models as they came to be, then the report.
/// What the command line cannot do (a range of the recording, files with columns of other
/// names) is a comment, and so is what has to be saved first. Recordings that only judge
/// are those of `compare --validate`. Throws NotNow without a recording.
[[nodiscard]] std::vector<std::string> command_lines(const SessionView& view);

}  // namespace workbench
