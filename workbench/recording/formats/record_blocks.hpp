// Rows of a database console that stand upright: a line a value.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace workbench {

/// The expanded display of psql (-[ RECORD 1 ]--- over lines of "name | value", with a
/// border, too) as a table: a row a record, a column a name. Nothing where no such head
/// is among the first 10 lines. O(bytes).
[[nodiscard]] std::optional<std::string> record_blocks_text(std::string_view text);

}  // namespace workbench
