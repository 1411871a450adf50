// Which columns make the time of a row.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "workbench/recording/csv_layout.hpp"
#include "workbench/recording/signal_choice.hpp"
#include "workbench/recording/times/time_column.hpp"

namespace workbench {

/// Columns that make a time.
struct TimePlace {
  std::size_t column = 0;             ///< number, date, or date and time
  std::optional<std::size_t> clock;   ///< time of day in a column of its own
  bool clock_is_number = false;       ///< that: 143000, 0.604167
  std::optional<std::size_t> millis;  ///< parts of the second in a column of their own
  double millis_s = 1e-3;             ///< of which each is this; s
  /// Hour, minute and perhaps second in columns of their own, beside a date; before them
  /// year, month and day where there is none (time_parts.hpp).
  std::vector<std::size_t> parts;
  TimeForm form = TimeForm::kNumber;
  double unit_s = 0;          ///< of numbers; 0: neither header nor user names one
  bool unit_given = false;    ///< by the user
  bool elapsed = false;       ///< by the name of the column no time of day
  std::string unknown_unit;   ///< of numbers: what the header says and nobody knows
  bool seconds_only = false;  ///< the contract's t: numbers are no Excel days
};

/// Lets a column T beside one with another name of time be no time, but, as a temperature
/// often is, a signal.
void tell_temperature(std::vector<LayoutColumn>& columns);

/// All columns of it, each once.
[[nodiscard]] std::vector<std::size_t> columns_of(const TimePlace& place);

/// Finds times by names and contents: the column named by the user or t, unless the user
/// takes it for a signal, else one of
/// dates and times, a date beside a time of day, hour, minute and second in columns of
/// their own, or a number with a name of time. Everything must outlive this.
class TimeFinder {
 public:
  TimeFinder(const CsvLayout& layout, const std::string& file, const ColumnNames& names,
             const std::vector<NamedSignal>& candidates);

  /// Nothing: no column is one. Throws InputError for two columns t and for a day without
  /// year and month beside hours, std::invalid_argument as candidate_named().
  [[nodiscard]] std::optional<TimePlace> find() const;
  /// The time that column `index` is, with what belongs to it.
  [[nodiscard]] TimePlace at(std::size_t index) const;

 private:
  [[nodiscard]] TimePlace named() const;
  [[nodiscard]] std::optional<std::size_t> column() const;
  [[nodiscard]] bool is_signal(const LayoutColumn& column) const;
  [[nodiscard]] std::optional<TimePlace> of_parts() const;
  void check_single_t(std::size_t first) const;
  void find_clock(std::size_t index, TimePlace& place) const;
  void find_clock_beside(TimePlace& place) const;
  void take_millis(std::size_t index, const LayoutColumn& seconds,
                   TimePlace& place) const;

  const std::vector<LayoutColumn>& columns_;
  const CsvLayout& layout_;
  const std::string& file_;
  const ColumnNames& names_;
  const std::vector<NamedSignal>& candidates_;
  std::vector<std::size_t> parts_;
};

}  // namespace workbench
