// One tag of an export in which each has times of its own, the order of its rows, and
// all of them side by side.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/recording/csv_source.hpp"
#include "workbench/recording/recording.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/recording/rows/row_scanner.hpp"
#include "workbench/recording/rows/row_table.hpp"
#include "workbench/recording/times/time_column.hpp"

namespace workbench {

/// One signal with its own times.
struct Stream {
  Stream(SignalRows of, TimeColumn at) : signal(std::move(of)), times(std::move(at)) {}

  SignalRows signal;
  std::string unit;  ///< that the rows name; "" none
  TimeColumn times;
  TimeCell first_cell;
  std::vector<std::uint32_t> line;
  std::vector<double> t;

  [[nodiscard]] bool is_of_loop() const {
    return signal.column == Column::u || signal.column == Column::y;
  }
};

/// Puts `part` behind `tag`, a point between; nothing where it is empty.
void add_to_tag(std::string& tag, std::string_view part);

/// The tag of a row from the cells in the slots `keys`; `tag` holds it where there are
/// several.
[[nodiscard]] std::string_view tag_of(const RowScanner& rows,
                                      const std::vector<std::size_t>& keys,
                                      std::string& tag);

/// Adds the tags of rows with these keys, one for each value: of several with the name of
/// its column behind. `column`: of the cell that says so.
void add_tags(std::string_view key, const ColumnChoice& choice, const CsvLayout& layout,
              std::size_t column, std::vector<NamedSignal>& tags);

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

/// A table of all streams, whose times rise. Equal times of all stay as they are;
/// otherwise it is the grid that tag_streams.hpp describes, and `on_grid` is set. Counts
/// and notes what it does. Throws InputError when u and y do not overlap in time or have
/// fewer than two samples.
[[nodiscard]] RowTable merged(std::vector<Stream> streams, const TableContext& context,
                              ResampleReport& report, bool& on_grid);

}  // namespace workbench
