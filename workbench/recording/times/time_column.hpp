// The times of a recording: from cells as written to seconds, once all rows are known.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "workbench/recording/spelling/cell_number.hpp"
#include "workbench/recording/times/times_of_rows.hpp"
#include "workbench/recording/written_time.hpp"

namespace workbench {

/// What the cells of a time column hold.
enum class TimeForm {
  kNumber,  ///< seconds or another unit, epoch seconds to nanoseconds, Excel's days
  kDate,    ///< date, with or without time of day
  /// Time of day alone, after midnight the next day begins; or time elapsed. Two numbers
  /// are minutes and seconds where the last has decimals or the first exceeds 24, as
  /// Excel saves what it shows: mm:ss.0. After the full hour the next begins.
  kClock,
};

/// Collects time cells and decides at the end what they mean.
///
/// Numbers are seconds unless the header or the user names another unit, or all of them
/// count dates (date_count.hpp) or are the digits of a clock (clock_digits.hpp). Numbers
/// in seconds stay as they are, epoch seconds included; all else starts from 0.
///
/// An open order of day and month is decided by a number above 12, by time that runs on
/// in one direction, and by dates that follow each other within a day in one
/// reading only. Where all rows are of one day it stays open, and the times are those of
/// that day, whichever it is. Cost: 12 bytes a row and, for dates, about 80 ns.
class TimeColumn {
 public:
  /// `unit_s`: seconds for one unit of the header; 0: none named.
  TimeColumn(TimeForm form, double unit_s, bool seconds_only,
             std::optional<DateOrder> order)
      : form_(form), unit_s_(unit_s), seconds_only_(seconds_only), order_(order) {}

  /// The unit is what the user says: of a clock with two numbers, and of numbers that are
  /// its digits, it is the unit of the last, s or min.
  void unit_is_given() { unit_given_ = true; }
  /// The header says that a clock of two numbers counts what elapsed: h:min or min:s.
  void is_elapsed() { elapsed_ = true; }
  /// The header names one that is not known.
  void unit_is_unknown(std::string unit) { unknown_unit_ = std::move(unit); }

  /// Adds a row. `clock` is the cell of a second column with the time of day, or empty;
  /// `extra_s` is added. False: no time, and nothing was added.
  [[nodiscard]] bool add(std::string_view cell, std::string_view clock, double extra_s);
  /// Adds a row whose time of day is a number beside the date, finite, of `digits` before
  /// its decimals. False: `cell` is no date, and nothing was added.
  [[nodiscard]] bool add(std::string_view cell, double clock, std::size_t digits,
                         double extra_s);
  /// Adds a number already read, finite.
  void add(double value) { seconds_.push_back(value); }

  [[nodiscard]] TimeForm form() const { return form_; }
  [[nodiscard]] std::size_t size() const { return seconds_.size(); }
  void reserve(std::size_t rows);

  /// Makes seconds of numbers beside dates, once all rows are in and before what follows.
  /// False: they are no times of day.
  [[nodiscard]] bool settle();
  /// The three numbers of the date of all rows, where there is one alone whose order they
  /// leave open, and the times run on in one direction.
  [[nodiscard]] std::optional<std::uint32_t> one_open_day() const;
  /// The readings between which dates of several days cannot decide, with what a date
  /// would be in each; nothing: decided, or no order fits all rows.
  struct Reading {
    DateOrder order;
    std::string date;  ///< "3 April 2026"
  };
  [[nodiscard]] std::vector<Reading> ambiguity() const;
  /// Open dates that no order of day and month reads in all rows.
  [[nodiscard]] bool unreadable() const;
  /// Requires neither. Frees what was collected.
  [[nodiscard]] TimesOfRows take();

 private:
  [[nodiscard]] bool reads(DateOrder order) const;
  [[nodiscard]] bool runs_on(DateOrder order) const;
  [[nodiscard]] double longest_step_s(DateOrder order) const;
  [[nodiscard]] std::int32_t day_at(std::size_t row, DateOrder order) const;
  [[nodiscard]] std::vector<DateOrder> orders() const;
  [[nodiscard]] bool take_digits(TimesOfRows& out);
  void take_bare(TimesOfRows& out, double& scale);
  [[nodiscard]] bool may_be_zone(std::string_view word);
  void take_zone(const WrittenTime& time);
  [[nodiscard]] bool add_day(const WrittenTime& time);
  void take_numbers(TimesOfRows& out);
  void take_clock(TimesOfRows& out);
  [[nodiscard]] bool minutes_and_seconds(TimesOfRows& out) const;
  void take_dates(TimesOfRows& out);
  // Clock times keep ticks of 100 ns, as .NET does.
  [[nodiscard]] static double tidy(double s) { return std::round(s * 1e7) / 1e7; }

  TimeForm form_;
  double unit_s_;
  bool unit_given_ = false;
  bool elapsed_ = false;
  std::string unknown_unit_;
  bool seconds_only_;
  std::optional<DateOrder> order_;
  std::vector<double> seconds_;      // of the day, or the number
  std::vector<std::uint32_t> days_;  // known: a day; open: three packed numbers
  WrittenTime::Day day_kind_ = WrittenTime::Day::kNone;
  bool has_zone_ = false;
  KnownZone first_zone_;
  std::optional<KnownZone> strange_zone_;  // that does not go with the first
  std::string zone_word_;                  // behind all times so far, not known
  bool short_clocks_ = true;               // all so far are two numbers
  bool decimals_ = false;                  // one of them has decimals
  std::size_t most_digits_ = 0;            // of numbers beside dates; 0: there are none
  std::string note_;                       // how these were taken
};

}  // namespace workbench
