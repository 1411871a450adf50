// Signals whose samples have times of their own.
#pragma once

#include "workbench/recording/csv_source.hpp"
#include "workbench/recording/recording.hpp"

namespace workbench {

/// Reads long format (a row a sample: tag, time, value, perhaps quality, rows in any
/// order) or columns in pairs (time, value, time, value), and puts the signals on one
/// grid.
///
/// In long format the tags are candidates for u, y, sp, x and loads as columns are
/// (signal_choice.hpp); the file is walked through twice, first for its tags. Samples
/// marked as bad are left out: the one before holds. Equal times of all signals stay
/// as they are; otherwise the grid has the shortest of the typical intervals of u and y,
/// from the last of the first samples to the last sample of u or y, and holds what was
/// last sampled up to a tenth of an interval after the instant; where u or y is silent
/// for longer than between its other samples (long_gaps.hpp), it has no value. A
/// setpoint, position or load that begins after the first tenth is left out. Counts and
/// notes all of it.
///
/// Throws InputError as csv.hpp says, and when u and y do not overlap in time.
void read_streams(const CsvSource& source, Recording& out);

}  // namespace workbench
