// Rows in which the loop was not recorded.
#pragma once

#include "workbench/recording/row_table.hpp"

namespace workbench {

/// Takes the rows out in which u or y has no value for so long that it is no ordinary
/// pause of that signal (long_gaps.hpp), as if they were missing; those before the first
/// value stay. Times must rise. Counts and notes them. O(n).
void take_out_rows_without(RowTable& table, ResampleReport& report);

}  // namespace workbench
