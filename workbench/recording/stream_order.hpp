// Rows of one signal that do not come in the order of their times.
#pragma once

#include <string>

#include "workbench/recording/recording.hpp"
#include "workbench/recording/tag_stream.hpp"
#include "workbench/recording/time_column.hpp"

namespace workbench {

/// Sorts the samples of `stream` by their times, with a note that is given once:
/// - stretches that rise and do not overlap: the parts of the file were put together in
///   another order;
/// - stretches that overlap and say the same there: they were exported twice;
/// - up to two rows, or one in a hundred, out of place;
/// - more than one row in twenty before the row above it: a table without an order.
/// Else the clock was set back, or two recordings are mixed: throws InputError naming the
/// first row that is too early. `times`: of stream.t. O(n log n).
void put_in_order(Stream& stream, const TimesOfRows& times, const std::string& file,
                  ResampleReport& report);

}  // namespace workbench
