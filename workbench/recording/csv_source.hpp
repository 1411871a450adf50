// One text, what is known of it, and what is wanted: the readers' common input.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "workbench/recording/column_choice.hpp"
#include "workbench/recording/csv.hpp"
#include "workbench/recording/csv_layout.hpp"
#include "workbench/recording/rows/value_reader.hpp"

namespace workbench {

struct CsvSource {
  std::string_view text;
  const std::string& file;
  const CsvLayout& layout;
  const ColumnChoice& choice;
  const CsvOptions& options;
};

/// What the layout of a text that is read so is looked for with.
[[nodiscard]] LayoutWish wish_of(const CsvOptions& options);

/// Where `column` is among those wanted, the slots of a RowScanner; added where it is not
/// yet. Signals may share a column of times or qualities.
[[nodiscard]] std::size_t want(std::vector<std::size_t>& wanted, std::size_t column);

/// Adds the columns of a time to those wanted, and where they then are.
[[nodiscard]] TimeSlots want_time(const CsvSource& source, const TimePlace& place,
                                  std::vector<std::size_t>& wanted);

/// A collector of the times of that place.
[[nodiscard]] TimeColumn time_column_of(const CsvSource& source, const TimePlace& place);

/// A signal as its column, or tag, has it, and the scale of its qualities.
[[nodiscard]] SignalRows rows_of(const CsvSource& source, Column column,
                                 const ColumnName& name,
                                 std::optional<std::size_t> quality);

/// Throws InputError where a signal has kMaxSamples rows already.
void require_room(const CsvSource& source, const RowScanner& rows, std::size_t count);

/// A time cell, for messages.
struct TimeCell {
  std::size_t line = 0;
  std::size_t column = 0;
  std::string text;
};

/// Throws InputError at the first cell of `times` when their dates have two readings.
void refuse_ambiguous(TimeColumn& times, const std::string& file, const TimeCell& first);

/// Throws InputError at the first cell when the times are in doubt, or numbers without a
/// unit more than a day, or less than 10 µs, apart.
void refuse_doubtful_times(const TimesOfRows& times, const std::string& file,
                           const TimeCell& first);

/// Throws InputError: the row at `at` is of `after`, the row before it of `before`.
[[noreturn]] void refuse_step_back(const TimesOfRows& times, TimeForm form,
                                   const std::string& file, const TimeCell& at,
                                   double before, double after);

}  // namespace workbench
