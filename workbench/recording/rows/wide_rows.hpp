// Tables with a row an instant and a column a signal.
#pragma once

#include "workbench/recording/csv_source.hpp"
#include "workbench/recording/recording.hpp"

namespace workbench {

/// Reads rows into `out`, csv.hpp says how. False, and nothing read: u and y have values
/// in rows of their own, as where tables of either are joined by their times; read then
/// as signals with own times (with_own_rows()).
[[nodiscard]] bool read_wide(const CsvSource& source, Recording& out);

/// The same columns, each with the times of the rows in which it has a value.
[[nodiscard]] ColumnChoice with_own_rows(ColumnChoice choice);

}  // namespace workbench
