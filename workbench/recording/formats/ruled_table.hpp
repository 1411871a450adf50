// Tables of database consoles and printers: columns of fixed width.
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

/// Of a text of columns of fixed width without a ruler, some of whose cells are blank:
/// the same with tabs between the columns, cut where all lines have a blank. Nothing:
/// another separator in the names, the first line; no row with fewer words than there are
/// names; or more or fewer stretches between blanks than names. O(n).
[[nodiscard]] std::optional<std::string> fixed_width_text(std::string_view text);

}  // namespace workbench
