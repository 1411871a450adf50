// Exports of TwinCAT Scope: attributes of each signal in lines of pairs, then rows of pairs
// of time and value.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace workbench {

/// The same lines with a header of names and units right above the rows, `t [ms]` before
/// each name, and nothing above it; nothing where `text` is no such export, or its values
/// still want a scale or an offset. Looks at the first 60 lines.
[[nodiscard]] std::optional<std::string> scope_text(std::string_view text);

}  // namespace workbench
