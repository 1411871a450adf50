// Names of columns over cells that they do not match one by one.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "workbench/recording/columns/line_table.hpp"
#include "workbench/recording/csv_layout.hpp"

namespace workbench {

/// Columns that are apart by any number of blanks.
inline constexpr char kBlanks = ' ';

/// The names in line `header` over the cells of the rows. Fewer than these: R writes none
/// over its row numbers, pandas neither, and a name stands over a date that a blank cuts
/// in two; only where a name of time then stands over times.
[[nodiscard]] std::vector<LineCell> names_of(const LineTable& table, std::size_t header);

/// Names for a file without a header: #1, #2, …; where two numbers or more of a row each
/// stand behind a cell that is the same in all rows and names a signal, these. A
/// separator behind the last value of each row makes no column.
[[nodiscard]] std::vector<LineCell> names_without_header(const LineTable& table);

/// Some name is there twice.
[[nodiscard]] bool has_repeated_names(const std::vector<LineCell>& cells);

/// The line from `highest` on above `header` whose first cell calls it one of tags:
/// "Point Name", "Tag"; as long as the header.
[[nodiscard]] std::optional<std::size_t> line_of_tags(const LineTable& table,
                                                      std::size_t header,
                                                      std::size_t highest);

/// "Value, Status, Value, Status" under "FIC101.OP, , FIC101.PV, ": one name each.
/// Nothing where `above` is a title.
void put_names_above(const std::vector<LineCell>& above,
                     const std::vector<LineCell>& cells,
                     std::vector<LayoutColumn>& columns);

/// #MS;#SP;#CMD: names behind a mark each, as many as a row has cells.
[[nodiscard]] bool is_remark_of_names(const std::vector<LineCell>& cells,
                                      std::size_t width);

/// Columns for cells behind the last name, where each row has as many: their texts are
/// their numbers (#6), by which alone they are found. None where commas separate and no
/// number has a point: the cells may be decimals.
void name_the_rest(const LineTable& table, std::vector<LayoutColumn>& columns);

}  // namespace workbench
