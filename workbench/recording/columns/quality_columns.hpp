// Which columns of a table say how good the values of another one are.
#pragma once

#include <vector>

#include "workbench/recording/columns/line_table.hpp"
#include "workbench/recording/csv_layout.hpp"

namespace workbench {

/// Settles the columns of qualities by what `table` holds in them. One whose name may
/// mean something else (Q, AirQuality) stays one only where its numbers are codes. The
/// name of a signal with a word for its quality behind it (OPQ, FIC101.OPquality,
/// FIC101.OP_ST) makes one of that signal, as does Q1 or PVQ right behind it, where its
/// cells are words of qualities or codes of OPC. A status of zeros and ones is one where
/// nine of ten are the same. The contents of `columns` must be known.
void settle_qualities(const LineTable& table, std::vector<LayoutColumn>& columns);

}  // namespace workbench
