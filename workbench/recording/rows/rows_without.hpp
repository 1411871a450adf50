// Values that are none: codes that historians and controllers write where one is missing,
// and rows in which the loop was not recorded.
#pragma once

#include "workbench/recording/rows/row_table.hpp"

namespace workbench {

/// Takes the rows out in which u or y has no value for so long that it is no ordinary
/// pause of that signal (long_gaps.hpp), as if they were missing; those before the first
/// value stay. Times must rise. Counts and notes them. O(n).
void take_out_rows_without(RowTable& table, ResampleReport& report);

/// Cells of `signal` that hold a code for "no value" become gaps, which is noted with the
/// code, how many and where. A code is one of the numbers in use for it (-9999, 9999,
/// -999.25, 32767, -32768, 65535 and the like) or beyond any measurement (1e29 and more),
/// and lies farther from all other values than five times their whole range: no signal
/// jumps there and back between two samples. One that is reached gradually, or lies in
/// the range of the signal, stays, as does one in more than half of the rows.
/// O(n).
void take_out_codes(SignalRows& signal, ResampleReport& report);

}  // namespace workbench
