// Tables with a row an instant and a column a signal.
#pragma once

#include "workbench/recording/csv_source.hpp"
#include "workbench/recording/recording.hpp"

namespace workbench {

/// Reads rows into `out`, csv.hpp says how.
void read_wide(const CsvSource& source, Recording& out);

}  // namespace workbench
