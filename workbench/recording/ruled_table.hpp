// Tables of database consoles: columns of fixed width under a ruler of dashes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace workbench {

/// Of a text whose names stand over a line of dashes, two groups or more, blanks between
/// them (SQLplus, sqlcmd, SQL*Plus): the same with tabs between the columns, each line
/// where it was; the names take the place of the ruler, and names repeated page by page
/// are left blank. Nothing: no ruler among the first 30 lines. O(n).
[[nodiscard]] std::optional<std::string> ruled_text(std::string_view text);

}  // namespace workbench
