#include "workbench/recording/columns/time_place.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "wire/text.hpp"
#include "workbench/recording/columns/line_table.hpp"
#include "workbench/recording/columns/long_format.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/time_parts.hpp"
#include "workbench/recording/time_unit.hpp"
#include "workbench/recording/times/date_count.hpp"

namespace workbench {
namespace {

constexpr double kMostOfADay = 0.9;  // of the rows say the same date

// The contract's t.
bool is_t(const LayoutColumn& column) {
  return column.name.part == Part::kTime && role_of(column.name.text) == Column::t;
}

// Ten digits are seconds from 2001 on, 13 milliseconds.
bool counts_since_1970(const LayoutColumn& column) {
  const std::string_view whole =
      std::string_view(column.first).substr(0, column.first.find_first_of(".,"));
  const bool digits = std::ranges::all_of(whole, wire::is_digit);
  return column.content == Content::kNumber && !column.rests() && digits &&
         whole.starts_with('1') && (whole.size() == 10 || whole.size() == 13);
}

// A date that its system writes with a time of day, always the same.
bool is_midnight(const LayoutColumn& column) {
  const std::optional<WrittenTime> time = written_time(column.first);
  return column.content == Content::kDateTime && column.held >= kMostOfADay && time &&
         time->seconds == 0 && !time->has_zone;
}

bool counts_whole(std::string_view cell) {
  return !cell.empty() && std::ranges::all_of(cell, wire::is_digit);
}

// The same number in most rows, and one that is written as dates are.
bool dates_as_numbers(const LayoutColumn& column) {
  return column.content == Content::kNumber && column.name.unit.empty() &&
         column.held >= kMostOfADay && date_digits(column.first);
}

bool is_day(const LayoutColumn& column) {
  return column.content == Content::kDate || is_midnight(column) ||
         (column.name.part == Part::kTime && dates_as_numbers(column));
}

// A time by itself: its parts beside it are not needed.
bool is_whole_time(const LayoutColumn& column) {
  if (column.content == Content::kDateTime) return !column.rests() && !is_day(column);
  return column.content == Content::kClock ||
         (column.content == Content::kNumber && column.name.part == Part::kTime &&
          is_measured(column) && !is_day(column));
}

}  // namespace

void tell_temperature(std::vector<LayoutColumn>& columns) {
  const auto is_time = [](const LayoutColumn& c) {
    return c.name.part == Part::kTime && !role_of(c.name.text) && is_measured(c) &&
           c.content != Content::kNothing;
  };
  if (std::ranges::none_of(columns, is_time)) return;
  for (LayoutColumn& column : columns) {
    if (column.name.text == "T" && column.content == Content::kNumber) {
      column.name.part = Part::kNone;
    }
  }
}

std::vector<std::size_t> columns_of(const TimePlace& place) {
  std::vector<std::size_t> out{place.column};
  if (place.clock) out.push_back(*place.clock);
  for (const std::size_t part : place.parts) {
    if (part != place.column) out.push_back(part);
  }
  if (place.millis) out.push_back(*place.millis);
  return out;
}

TimeFinder::TimeFinder(const CsvLayout& layout, const std::string& file,
                       const ColumnNames& names,
                       const std::vector<NamedSignal>& candidates)
    : columns_(layout.columns),
      layout_(layout),
      file_(file),
      names_(names),
      candidates_(candidates),
      parts_(time_parts(layout)) {}

std::optional<TimePlace> TimeFinder::find() const {
  if (!names_.time.empty()) return named();
  const std::optional<std::size_t> found = column();
  if (found && is_t(columns_[*found])) {
    check_single_t(*found);
  } else {
    if (std::optional<TimePlace> parts = of_parts()) return parts;
  }
  if (!found) return std::nullopt;
  return at(*found);
}

// By the user.
bool TimeFinder::is_signal(const LayoutColumn& column) const {
  const std::string& text = column.name.text;
  const auto is_it = [&](const std::string& name) {
    return !name.empty() && name == text;
  };
  return is_it(names_.u) || is_it(names_.y) || is_it(names_.sp) || is_it(names_.x);
}

std::optional<std::size_t> TimeFinder::column() const {
  using Fits = bool (*)(const LayoutColumn&);
  constexpr auto kInTurn = std::to_array<Fits>({
      [](const LayoutColumn& c) { return is_t(c) && c.content != Content::kText; },
      // The bounds of a query stand beside the times of its rows, the same in all of
      // them.
      [](const LayoutColumn& c) { return c.content == Content::kDateTime && !c.rests(); },
      [](const LayoutColumn& c) { return c.content == Content::kDate && !c.rests(); },
      [](const LayoutColumn& c) { return c.content == Content::kDateTime; },
      [](const LayoutColumn& c) { return c.content == Content::kDate; },
      [](const LayoutColumn& c) {
        return c.name.part == Part::kTime && is_measured(c) &&
               c.content != Content::kNothing;
      },
      [](const LayoutColumn& c) { return c.content == Content::kClock; },
      [](const LayoutColumn& c) {
        return c.name.part == Part::kMillis && c.name.tag.empty() && is_measured(c) &&
               c.content != Content::kNothing && !c.rests();
      },
      // The sample period alone, in the first row, makes no times.
      [](const LayoutColumn& c) {
        return c.name.part == Part::kTime && c.content != Content::kNothing;
      },
  });
  for (const Fits fits : kInTurn) {
    const auto may_be = [&](const LayoutColumn& c) { return fits(c) && !is_signal(c); };
    if (const auto found = first_column(columns_, may_be)) return found;
  }
  // Without a header, seconds or parts of them since 1970.
  if (!layout_.header.empty()) return std::nullopt;
  return first_column(columns_, counts_since_1970);
}

// Hour, minute and second, with the day beside them, where no column is a whole time.
std::optional<TimePlace> TimeFinder::of_parts() const {
  if (parts_.empty()) return std::nullopt;
  TimePlace place;
  place.parts = parts_;
  place.column = parts_.front();
  place.form = parts_have_date(parts_.size()) ? TimeForm::kDate : TimeForm::kClock;
  std::optional<std::size_t> date;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (std::ranges::find(parts_, i) != parts_.end()) continue;
    if (is_whole_time(columns_[i])) return std::nullopt;
    if (!date && is_day(columns_[i])) date = i;
  }
  if (place.form == TimeForm::kClock) {
    if (date) {
      place.column = *date;
      place.form = TimeForm::kDate;
    } else if (const auto day = lone_day(layout_, parts_)) {
      throw InputError(file_, layout_.header_line, columns_[*day].column,
                       "year, month and day, or a date, beside hour and minute",
                       quoted(columns_[*day].name.text) + " without the others",
                       "export the whole date, or, if all rows are of one day, without "
                       "that column");
    }
  }
  if (parts_have_second(parts_.size())) {
    take_millis(parts_.back() + 1, columns_[parts_.back()], place);
  }
  return place;
}

// "Ticks [ms]", "#1 [min]": with the unit of a column that names none, or a wrong one.
TimePlace TimeFinder::named() const {
  const std::size_t open = names_.time.rfind(" [");
  double unit_s = 0;
  if (open != std::string::npos && names_.time.back() == ']') {
    unit_s = seconds_of_unit(
        std::string_view(names_.time).substr(open + 2, names_.time.size() - open - 3));
  }
  const bool in_name = std::ranges::any_of(columns_, [this](const LayoutColumn& column) {
    return column.name.text == names_.time;
  });
  const bool behind = unit_s > 0 && !in_name;
  const std::size_t index =
      candidate_named(behind ? names_.time.substr(0, open) : names_.time, "--time",
                      candidates_, {file_, layout_.header_line, "columns"});
  if (unit_s <= 0) {
    const std::optional<TimePlace> parts = of_parts();
    if (parts) {
      const std::vector<std::size_t> all = columns_of(*parts);
      if (std::ranges::find(all, index) != all.end()) return *parts;
    }
  }
  TimePlace place = at(index);
  if (unit_s <= 0) return place;
  place.unit_s = unit_s;
  place.unit_given = true;
  place.unknown_unit.clear();
  return place;
}

void TimeFinder::check_single_t(std::size_t first) const {
  for (std::size_t i = first + 1; i < columns_.size(); ++i) {
    if (!is_t(columns_[i]) || is_signal(columns_[i])) continue;
    throw InputError(file_, layout_.header_line, columns_[i].column, "one column for t",
                     "both " + quoted(columns_[first].name.text) + " and " +
                         quoted(columns_[i].name.text),
                     "rename or remove one of them, or name the right one with --time");
  }
}

TimePlace TimeFinder::at(std::size_t index) const {
  TimePlace place;
  place.column = index;
  const LayoutColumn& column = columns_[index];
  place.seconds_only = is_t(column);
  place.elapsed = column.name.key.find("elapsed") != std::string::npos;
  place.unit_s = seconds_of_unit(column.name.unit);
  if (place.unit_s == 0) place.unit_s = seconds_of_unit(column.name.key);
  if (place.unit_s == 0) place.unit_s = unit_in_name(column.name.text);
  const bool names_unit = !column.name.unit.empty() && column.name.unit != "-";
  if (place.unit_s == 0 && names_unit) place.unknown_unit = quoted(column.name.unit);
  const bool once =
      column.content == Content::kNothing && kind_of(column.first) == CellKind::kDateTime;
  if (once || column.content == Content::kDateTime || column.content == Content::kDate) {
    place.form = TimeForm::kDate;
  } else if (column.content == Content::kClock) {
    place.form = TimeForm::kClock;
  }
  if (const double form_s = seconds_of_clock_form(column.name.unit);
      form_s > 0 && place.form == TimeForm::kClock) {
    place.unit_s = form_s;
    place.unit_given = true;
    place.unknown_unit.clear();
  }
  find_clock(index, place);
  const std::size_t last = place.clock.value_or(place.column);
  const bool whole_s = place.unit_s == 1 && column.first.find('.') == std::string::npos;
  if (place.form != TimeForm::kNumber || whole_s) {
    take_millis(last + 1, columns_[last], place);
  }
  return place;
}

// The time of day in a column of its own, or the date beside one.
void TimeFinder::find_clock(std::size_t index, TimePlace& place) const {
  const LayoutColumn& column = columns_[index];
  if (!place.seconds_only && dates_as_numbers(column)) find_clock_beside(place);
  if (column.content == Content::kDate || is_midnight(column)) {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const Content other = columns_[i].content;
      const bool full =
          other == Content::kDateTime && columns_[i].name.part == Part::kTime;
      if (i != index && (other == Content::kClock || full)) {
        place.clock = i;
        break;
      }
    }
  }
  if (column.content == Content::kDate && !place.clock) find_clock_beside(place);
  if (column.content != Content::kClock || names_.time.empty()) return;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (columns_[i].content != Content::kDate) continue;
    place.clock = index;
    place.column = i;
    place.form = TimeForm::kDate;
    break;
  }
}

// Milliseconds or microseconds of the second before, which do not count on while that
// goes on.
void TimeFinder::take_millis(std::size_t index, const LayoutColumn& seconds,
                             TimePlace& place) const {
  constexpr double kMicro = 1e-6;
  if (index >= columns_.size()) return;
  const LayoutColumn& column = columns_[index];
  if (column.counts && !seconds.rests()) return;
  const bool micros = seconds_of_unit(column.name.text) == kMicro &&
                      column.content == Content::kNumber && counts_whole(column.first);
  const bool millis = column.name.part == Part::kMillis && column.name.tag.empty();
  if (!micros && !millis) return;
  place.millis = index;
  if (micros) place.millis_s = kMicro;
}

// The time of day as a number, or beside a date that is one, in the next column.
void TimeFinder::find_clock_beside(TimePlace& place) const {
  const std::size_t next = place.column + 1;
  if (next >= columns_.size()) return;
  const LayoutColumn& clock = columns_[next];
  const bool number = clock.content == Content::kNumber &&
                      clock.name.part == Part::kTime && clock.name.unit.empty();
  if (!number && clock.content != Content::kClock) return;
  place.clock = next;
  place.clock_is_number = number;
  place.form = TimeForm::kDate;
}

}  // namespace workbench
