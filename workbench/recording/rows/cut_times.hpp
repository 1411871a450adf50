// Time stamps whose seconds or fractions the export cut off.
#pragma once

#include <string>

#include "workbench/recording/rows/row_table.hpp"
#include "workbench/recording/times/time_column.hpp"

namespace workbench {

/// Spreads rows of clock times evenly whose stamps are cut or rounded to a coarser step
/// (rounded_times.hpp); else those that share whole minutes or whole seconds: one such
/// step apart throughout, at least two rows to each stamp and equally many within one or
/// a tenth. All of them must be complete, and not copies of each other; nothing is done
/// where each row of a stamp is a copy. Returns a note, or "" where nothing was done.
/// Excel writes such files: it saves what a cell shows, hh:mm. O(n).
[[nodiscard]] std::string spread_cut_times(RowTable& table, const TimesOfRows& times);

}  // namespace workbench
