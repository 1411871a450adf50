// Log lines of name=value.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace workbench {

/// Lines as programs log them (2026-03-04T06:00:01Z level=info op=4.5 pv=6.1) as a table:
/// a row a line, a column a name, "time" for what leads a line and begins with a digit,
/// a date and a clock with a blank between them, too. Values may be quoted; other words
/// and lines without a value are left out. Nothing where less than three quarters of the
/// first 40 lines are such: two values or more, or one behind a time. O(bytes).
[[nodiscard]] std::optional<std::string> logfmt_text(std::string_view text);

}  // namespace workbench
