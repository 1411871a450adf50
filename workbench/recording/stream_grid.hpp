// Signals with times of their own, put side by side.
#pragma once

#include <vector>

#include "workbench/recording/recording.hpp"
#include "workbench/recording/row_table.hpp"
#include "workbench/recording/tag_stream.hpp"

namespace workbench {

/// A table of all streams, whose times rise. Equal times of all stay as they are;
/// otherwise it is the grid that tag_streams.hpp describes, and `on_grid` is set. Counts
/// and notes what it does. Throws InputError when u and y do not overlap in time or have
/// fewer than two samples.
[[nodiscard]] RowTable merged(std::vector<Stream> streams, const TableContext& context,
                              ResampleReport& report, bool& on_grid);

}  // namespace workbench
