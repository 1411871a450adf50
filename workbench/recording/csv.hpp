// CSV recordings.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/recording/input_error.hpp"
#include "workbench/recording/recording.hpp"
#include "workbench/recording/signal_choice.hpp"
#include "workbench/recording/workbook.hpp"
#include "workbench/recording/written_time.hpp"

namespace workbench {

struct CsvOptions {
  std::optional<double>
      ts;  ///< sample period in s; replaces any column t, > 0 and finite
  std::vector<Column> required = {Column::u, Column::y};  ///< absent one = InputError
  ColumnNames names = {};  ///< columns or tags by name, signal_choice.hpp
  std::optional<DateOrder> date_order =
      {};                            ///< where dates leave it open; time_column.hpp
  std::optional<char> decimal = {};  ///< '.' or ',': the other one groups thousands
  std::string sheet = {};            ///< of a workbook; "": the one with the columns
  std::stop_token stop = {};         ///< asks for an end: Stopped is thrown
};

/// Which sheet of a workbook is meant: the one named, or the one with the columns.
/// `options` must outlive it.
[[nodiscard]] SheetChoice sheet_wanted(const CsvOptions& options);

/// Reads a CSV recording.
///
/// A *plain* file has the contract's names in its first line, in any order and case:
/// t (s), u or OP, y or PV, sp, x or MV or POS; other columns are ignored, whatever
/// they hold. Separator comma, semicolon, tab or |, told from the header; lines end
/// with LF, CRLF or CR; a byte-order mark, quotes, spaces around values and empty
/// lines at the end are accepted. With another separator than the comma the decimal mark
/// may be a comma, the same one throughout the file. Text, NaN and infinities are errors.
///
/// Everything else is an *export* of a historian or spreadsheet; docs/exports.md has the
/// table. UTF-16 and Windows-1252 too (text_encoding.hpp); preambles, units and rows
/// of units (csv_layout.hpp); tags and which of them are u and y (signal_choice.hpp);
/// dates, epochs and Excel's days (written_time.hpp, time_column.hpp), newest first and
/// daylight saving (times_of_rows.hpp); long format and signals with times of their own
/// (tag_streams.hpp); thousands separators (cell_number.hpp); qualities.
///
/// In both, an empty cell and a word for "no value" (bad_value.hpp has the list, which
/// ends where a typing mistake begins) is a gap: the value before is held; rows before
/// the first complete one are dropped. More than half of u or y so marked is an error. A
/// row that repeats the time before it is dropped, but first supplies values that one
/// lacked. All of it is counted and noted; resample.hpp says how time stamps become a
/// grid.
///
/// Throws InputError for: no header, a missing or duplicate column, several loops and
/// none named, text where a number belongs, in a plain file NaN and infinities too, dates
/// with two readings, a step back in time that is no restart (restarts.hpp), a row with
/// more or fewer cells than the header, an empty line before the last row of a plain
/// file, fewer than 2 samples, gaps or files too long (kMaxSamples, 512 MiB). Throws
/// std::invalid_argument when `ts` is not a positive number, or a name of `names` fits no
/// column or several; Stopped where `stop` asks for it. A million rows of three columns
/// take about 0.2 s; 100,000 rows of 200 columns 0.4 s.
[[nodiscard]] Recording read_csv(const std::string& path, const CsvOptions& options = {});

/// What `parse_csv` does once it knows the columns: reads the rows of a source. Throws
/// InputError.
struct CsvSource;
[[nodiscard]] Recording read_table(const CsvSource& source);

/// As read_csv, for a text already in memory; `name` stands in messages.
[[nodiscard]] Recording parse_csv(std::string_view text, const std::string& name,
                                  const CsvOptions& options = {});

}  // namespace workbench
