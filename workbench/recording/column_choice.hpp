// What to read from which column of a file.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "workbench/recording/columns/time_place.hpp"
#include "workbench/recording/csv_layout.hpp"
#include "workbench/recording/signal_choice.hpp"

namespace workbench {

struct SignalPlace {
  Column column = Column::u;  ///< of a load: Column::t
  std::size_t index = 0;      ///< of the column
  std::optional<std::size_t> quality;
  std::optional<std::size_t> time;  ///< of `times`: where signals have their own
};

/// What to read.
struct ColumnChoice {
  enum class Shape {
    kWide,      ///< a row an instant, a column a signal
    kOwnTimes,  ///< a time column beside each signal
    kLong,      ///< a row a sample of the signal, or of the loop, that its keys name
  };
  Shape shape = Shape::kWide;
  std::vector<TimePlace> times;      ///< kWide, kLong: one, or none with a given period
  std::vector<SignalPlace> signals;  ///< none for kLong
  /// kLong: one, or the columns of a loop each.
  struct Value {
    std::size_t column = 0;
    std::optional<std::size_t> quality;
    std::optional<std::size_t> whole;  ///< the column of values that are whole numbers
  };
  std::vector<std::size_t> keys;    ///< kLong: their texts with points between: the tag
  std::vector<Value> values;        ///< kLong; of several the names follow the keys
  std::optional<std::size_t> unit;  ///< kLong: the column that names the unit of a value
  std::optional<std::size_t> mode;  ///< kWide: mode_column.hpp
  /// The contract's own file: bare names in the first line, times in seconds. Every cell
  /// must be a number or empty.
  bool plain = false;
  bool own_rows = false;  ///< kOwnTimes: a row without a value is no sample of a signal
  std::vector<std::string> notes;  ///< what was taken as meant
};

/// Chooses by names and contents. The time is what time_place.hpp finds.
/// Long format is told by a tag and a value column without u and y beside them, or by
/// rows of several loops in turn (row_keys()). A quality column belongs to the signal
/// in its name, the only one of the file to all, another to the column left of it, or
/// right of it where that is the only one with values. Throws
/// as choose_signals(), and InputError when no time is found although `time_needed`.
[[nodiscard]] ColumnChoice choose_columns(const CsvLayout& layout,
                                          const std::string& file,
                                          const ColumnNames& names,
                                          const std::vector<Column>& required,
                                          bool time_needed);

/// The columns as candidates for signals; their index is that of the column.
[[nodiscard]] std::vector<NamedSignal> candidates_of(const CsvLayout& layout);

/// Of each of the columns `signals` the column of its times; nothing where all rows have
/// one time. Told by the names where each signal has a time of its name (FIC101.PV and
/// FIC101.PV Time); else by the side: where times stand before the first signal, each has
/// the next time to its left, otherwise the next one to its right; at least two of the
/// times must then stand beside a number on that side. Times that rest (the bounds of a
/// query) do not count. Of no signals: an empty list where two times stand before
/// numbers.
[[nodiscard]] std::optional<std::vector<std::size_t>> own_times(
    const CsvLayout& layout, const std::vector<std::size_t>& signals);

}  // namespace workbench
