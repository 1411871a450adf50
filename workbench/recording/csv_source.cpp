#include "workbench/recording/csv_source.hpp"

#include <algorithm>

#include "workbench/recording/input_error.hpp"
#include "workbench/recording/listed.hpp"
#include "workbench/recording/spelling/quality_words.hpp"
#include "workbench/recording/time_unit.hpp"

namespace workbench {

LayoutWish wish_of(const CsvOptions& options) {
  LayoutWish wish{options.required, {}, options.decimal};
  if (!options.ts) wish.required.insert(wish.required.begin(), Column::t);
  for (const Column column : kAllColumns) {
    const std::string& name = options.names.of(column);
    if (!name.empty() && name[0] != '#') wish.named.push_back(name);
  }
  return wish;
}

std::size_t want(std::vector<std::size_t>& wanted, std::size_t column) {
  const auto known = std::ranges::find(wanted, column);
  if (known != wanted.end()) return static_cast<std::size_t>(known - wanted.begin());
  wanted.push_back(column);
  return wanted.size() - 1;
}

TimeSlots want_time(const CsvSource& source, const TimePlace& place,
                    std::vector<std::size_t>& wanted) {
  TimeSlots slots;
  slots.column = want(wanted, place.column);
  if (place.clock) slots.clock = want(wanted, *place.clock);
  slots.clock_is_number = place.clock_is_number;
  if (place.millis) slots.millis = want(wanted, *place.millis);
  slots.millis_s = place.millis_s;
  for (const std::size_t part : place.parts) {
    slots.parts.push_back(want(wanted, part));
    slots.name +=
        (part == place.parts.front() ? "" : " ") + source.layout.columns[part].name.text;
  }
  if (place.parts.empty()) slots.name = source.layout.columns[place.column].name.text;
  return slots;
}

TimeColumn time_column_of(const CsvSource& source, const TimePlace& place) {
  TimeColumn out(place.form, place.unit_s, place.seconds_only, source.options.date_order);
  if (place.unit_given) out.unit_is_given();
  if (place.elapsed) out.is_elapsed();
  out.unit_is_unknown(place.unknown_unit);
  return out;
}

SignalRows rows_of(const CsvSource& source, Column column, const ColumnName& name,
                   std::optional<std::size_t> quality) {
  SignalRows out;
  out.column = column;
  out.name = name.text;
  out.unit = name.unit;
  if (quality) {
    out.scale = QualityScale(marks_bad(source.layout.columns[*quality].name.pieces));
  }
  return out;
}

void require_room(const CsvSource& source, const RowScanner& rows, std::size_t count) {
  if (count < kMaxSamples) return;
  throw InputError(source.file, rows.line(), 0,
                   "at most " + std::to_string(kMaxSamples) + " rows", "more",
                   "split the recording");
}

void refuse_ambiguous(TimeColumn& times, const std::string& file, const TimeCell& first) {
  if (!times.settle()) {
    throw InputError(file, first.line, first.column,
                     "times of day beside the dates, as 143000, 0.604167 or 14:30:00",
                     "numbers that are none, or may be HHMM as well as HHMMSS",
                     "export the time as 14:30:00, or give --ts SECONDS");
  }
  if (times.unreadable()) {
    throw InputError(file, first.line, first.column, "dates of one order",
                     quoted(first.text) + " and others that are no dates so",
                     "export dates as 2026-05-03");
  }
  const std::vector<TimeColumn::Reading> readings = times.ambiguity();
  if (readings.empty()) return;
  std::string options;
  for (const TimeColumn::Reading& reading : readings) {
    options += (options.empty() ? "--date-order " : " or --date-order ") +
               std::string(name_of(reading.order));
  }
  throw InputError(file, first.line, first.column, "dates with one reading",
                   quoted(first.text) + ", which may be " +
                       listed(readings, " or ", &TimeColumn::Reading::date),
                   "say which it is: " + options);
}

void refuse_doubtful_times(const TimesOfRows& times, const std::string& file,
                           const TimeCell& first) {
  if (times.doubt) {
    throw InputError(file, first.line, first.column, times.doubt->expected,
                     times.doubt->found, times.doubt->advice);
  }
  constexpr double kShortestS = 1e-5;
  constexpr double kLongestS = 86400;
  const double step = times.bare_step_s;
  if (step == 0 || (step >= kShortestS && step <= kLongestS)) return;
  throw InputError(file, first.line, first.column,
                   "times in seconds, 10 µs to a day apart",
                   "numbers without a unit, " + number(step) + " apart",
                   "name the unit in the header, as in \"t [us]\", or give --ts SECONDS");
}

void refuse_step_back(const TimesOfRows& times, TimeForm form, const std::string& file,
                      const TimeCell& at, double before, double after) {
  const auto text = [&times, form](double time) {
    const std::string clock = clock_text(times, time);
    return clock.empty() || form == TimeForm::kNumber ? number(time, 12) + " s" : clock;
  };
  constexpr double kHalfDayS = 12 * kHourS;
  const double back = before - after;
  const bool twelve =
      form != TimeForm::kNumber && back > kHalfDayS - kHourS && back < kHalfDayS;
  throw InputError(file, at.line, at.column, "a time not before " + text(before),
                   text(after),
                   twelve ? "export a clock of 24 hours, or AM and PM: this one begins "
                            "anew after 12"
                          : "sort the rows by time, or split the recording there");
}

}  // namespace workbench
