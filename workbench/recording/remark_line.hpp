// Lines of words between the rows of an export.
#pragma once

#include <span>
#include <string_view>

#include "workbench/recording/csv_layout.hpp"

namespace workbench {

/// Whether a line that is no row is none without doubt: `cells` are those of the wanted
/// columns, from the left, `first` that of the first row in the leftmost of them. One of
/// them alone says something, and no number (`--- shift change ---`, `Page of shift B`);
/// or the leftmost is Average, Min, Total or the like; or the line begins with a mark.
/// Not where a cell is the name of a column or a unit that none has, for the columns may
/// be others there, and not where rows begin with letters themselves, but with a mark.
/// `behind_head`: the header stands above once more, and units may follow it.
[[nodiscard]] bool is_remark(std::span<const std::string_view> cells,
                             std::string_view first, const CsvLayout& layout,
                             bool behind_head);

}  // namespace workbench
