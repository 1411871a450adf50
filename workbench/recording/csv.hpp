// CSV recordings.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/recording/input_error.hpp"
#include "workbench/recording/recording.hpp"

namespace workbench {

struct CsvOptions {
  std::optional<double>
      ts;  ///< sample period in s; replaces any column t, > 0 and finite
  std::vector<Column> required = {Column::u, Column::y};  ///< absent one = InputError
};

/// Reads a CSV recording. A header row names the columns, in any order and case:
/// t (s), u or OP, y or PV, sp, x or MV or POS; other columns are ignored, whatever
/// they hold. Separator comma, semicolon or tab, told from the header; lines end
/// with LF, CRLF or CR; a byte-order mark, quotes, spaces around values and empty
/// lines at the end are accepted. With semicolon or tab the decimal mark may be a
/// comma, the same one throughout the file.
///
/// An empty cell is a missing value: the one before is held; rows before the first
/// complete one are dropped. A row that repeats the time before it is
/// dropped, but first supplies values that one lacked. All of it is
/// counted and noted; resample.hpp says how time stamps become a grid.
///
/// Throws InputError for: no header, a missing or duplicate column, text, NaN or an
/// infinity where a number belongs, a step back in time, a row with more or fewer
/// cells than the header, an empty line before the last row, fewer than 2 samples,
/// gaps or files too long (kMaxSamples, 512 MiB). Throws std::invalid_argument when
/// `ts` is not a positive number. A million rows take about 0.2 s.
[[nodiscard]] Recording read_csv(const std::string& path, const CsvOptions& options = {});

/// The same for a text already in memory; `name` stands in messages.
[[nodiscard]] Recording parse_csv(std::string_view text, const std::string& name,
                                  const CsvOptions& options = {});

}  // namespace workbench
