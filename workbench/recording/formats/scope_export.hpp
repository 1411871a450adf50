// Exports of TwinCAT Scope: a line for each attribute of the signals, then rows of a time
// and the values of the signals that share it, one group after the other.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace workbench {

/// The same lines with a header of names and units right above the rows, `t [ms]`, or
/// `Time` where the rows have the 100 ns of Windows, before each group, and nothing above
/// it; nothing where `text` is no such export. A scale or an offset other than 1 and 0 is
/// put into the name: the file does not tell whether its values were scaled. Looks at the
/// first 60 lines.
[[nodiscard]] std::optional<std::string> scope_text(std::string_view text);

}  // namespace workbench
