// Columns that tell the rows of one signal, or of one loop, from those of another.
#pragma once

#include <cstddef>
#include <vector>

#include "workbench/recording/csv_layout.hpp"

namespace workbench {

/// Columns of text that have to be read beside `given` (those of a long format; none) to
/// know whose row it is, told from the first rows: loop, device, element, ... A column
/// counts
/// - where rows of one tag repeat a time with another text, and with the text none does;
/// - where its texts take turns from row to row;
/// - where it has a name of tags and changes often, or says one tag in all of the first
///   rows and another one later.
/// What says how good a value is, or in which state a loop, does neither. `times`: the
/// columns that make the time of a row. In the order of the columns, `given` among them,
/// those that name a part of what others name (field, attribute, parameter) last.
/// O(columns of text · rows).
[[nodiscard]] std::vector<std::size_t> row_keys(const CsvLayout& layout,
                                                const std::vector<std::size_t>& times,
                                                const std::vector<std::size_t>& given);

}  // namespace workbench
