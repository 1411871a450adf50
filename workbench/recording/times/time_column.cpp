#include "workbench/recording/times/time_column.hpp"

#include <algorithm>

#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/recording/time_unit.hpp"
#include "workbench/recording/times/clock_digits.hpp"
#include "workbench/recording/times/date_count.hpp"
#include "workbench/recording/times/time_spelling.hpp"

namespace workbench {
namespace {

using Day = WrittenTime::Day;

// Days written with few digits, or so meant: all within 20 ms of whole seconds.
void round_to_seconds(std::vector<double>& t, double& origin) {
  constexpr double kFewDigits = 0.02;
  const bool whole = std::ranges::all_of(t, [origin](double v) {
    return std::abs(v + origin - std::round(v + origin)) < kFewDigits;
  });
  if (!whole) return;
  const double first = std::round(origin);
  for (double& v : t) v = std::round(v + origin) - first;
  origin = first;
}

// 14:05:30, or 14.05.30 in a column of such.
std::optional<WrittenTime> written_clock(std::string_view cell) {
  const std::optional<std::string> colons = dotted_clock(cell);
  return written_time(colons ? std::string_view(*colons) : cell);
}

}  // namespace

void TimeColumn::reserve(std::size_t rows) {
  seconds_.reserve(rows);
  if (form_ == TimeForm::kDate) days_.reserve(rows);
}

bool TimeColumn::add(std::string_view cell, std::string_view clock, double extra_s) {
  std::optional<WrittenTime> time =
      form_ == TimeForm::kClock ? written_clock(cell) : written_time(cell, order_);
  if (!time && !clock.empty()) time = date_digits(cell, order_);
  if (!time || (form_ == TimeForm::kDate) != (time->kind != Day::kNone)) return false;
  if (!clock.empty()) {
    const std::optional<WrittenTime> of_day = written_clock(clock);
    if (!of_day || of_day->kind != Day::kNone) {
      // Some systems write the date into both columns, midnight in the first.
      if (!of_day || !of_day->has_clock) return false;
    }
    if (of_day->seconds > kDayS && !of_day->has_zone) return false;
    time->has_zone = of_day->has_zone;
    time->zone_min = of_day->zone_min;
    time->open_zone = of_day->open_zone;
    time->seconds = of_day->seconds;
  }
  if (!may_be_zone(time->zone_word)) return false;
  if (form_ == TimeForm::kDate && !add_day(*time)) return false;
  take_zone(*time);
  short_clocks_ = short_clocks_ && time->short_clock;
  decimals_ = decimals_ || time->decimal;
  seconds_.push_back(time->seconds + extra_s);
  return true;
}

bool TimeColumn::add(std::string_view cell, double clock, std::size_t digits,
                     double extra_s) {
  std::optional<WrittenTime> date = written_time(cell, order_);
  if (!date) date = date_digits(cell, order_);
  if (!date || date->kind == Day::kNone || !add_day(*date)) return false;
  most_digits_ = std::max({most_digits_, digits, std::size_t{1}});
  seconds_.push_back(clock + extra_s);
  return true;
}

// A word for a zone that is not known: the same one behind all times.
bool TimeColumn::may_be_zone(std::string_view word) {
  if (seconds_.empty()) zone_word_ = word;
  return word == zone_word_;
}

void TimeColumn::take_zone(const WrittenTime& time) {
  const KnownZone zone{time.zone_min, time.open_zone};
  if (seconds_.empty()) {
    has_zone_ = time.has_zone;
    first_zone_ = zone;
  } else if (time.has_zone && has_zone_ && !go_together(first_zone_, zone)) {
    strange_zone_ = zone;
  }
}

bool TimeColumn::settle() {
  if (most_digits_ == 0) return true;
  const bool passes_days =
      std::ranges::adjacent_find(days_, std::not_equal_to<>()) != days_.end();
  std::optional<DayTimes> of_day = times_of_day(seconds_, most_digits_, passes_days);
  if (!of_day) return false;
  note_ = "the numbers beside the dates are taken as times of day, " + of_day->form;
  seconds_ = std::move(of_day->seconds);
  most_digits_ = 0;
  return true;
}

TimesOfRows TimeColumn::take() {
  TimesOfRows out;
  if (seconds_.empty()) return out;
  switch (form_) {
    case TimeForm::kNumber:
      take_numbers(out);
      break;
    case TimeForm::kClock:
      take_clock(out);
      break;
    case TimeForm::kDate:
      take_dates(out);
      break;
  }
  days_ = {};
  seconds_ = {};
  return out;
}

bool TimeColumn::take_digits(TimesOfRows& out) {
  if (unit_s_ > 0 && !unit_given_) return false;
  if (unit_s_ != 0 && unit_s_ != 1 && unit_s_ != 60) return false;
  std::optional<ClockDigits> clock = clock_digits(seconds_, unit_s_ == 60);
  if (!clock) return false;
  if (clock->open && unit_s_ == 0) {
    out.doubt = doubt_of_clock("the digits of a clock, MMSS or HHMM");
  }
  out.notes.push_back("the times are taken as the digits of a clock, " + clock->form);
  out.t = std::move(clock->t);
  out.origin_seconds = clock->first_s;
  out.dated = clock->day.has_value();
  out.origin_day = clock->day.value_or(0);
  return true;
}

// Numbers whose unit nobody names.
void TimeColumn::take_bare(TimesOfRows& out, double& scale) {
  if (!unknown_unit_.empty()) {
    out.doubt = {"times in a known unit: s, ms, min, h",
                 "the unit " + unknown_unit_ + " in the header",
                 "say which it is after the name, --time \"NAME [ms]\", or give --ts "
                 "SECONDS"};
    return;
  }
  const double step = median_step(seconds_);
  if (is_step_in_days(step) || are_rounded_days(seconds_)) {
    scale = kDayS;
    out.notes.emplace_back(
        "the times are taken as days: as seconds they would be less than a thousandth "
        "apart; where they are, give --ts SECONDS");
    return;
  }
  if (!seconds_only_ && may_be_parts_of_day(seconds_)) {
    out.doubt = doubt_of_days(
        filled("numbers below 1 and {0} apart, which may be seconds or parts of a day",
               {number(step)}));
    return;
  }
  out.bare_step_s = step;
  if (!seconds_only_ && (is_unusual_step(step) || is_uneven_count(seconds_))) {
    out.notes.push_back("the times name no unit: taken as seconds, " + number(step) +
                        " apart; where they are milliseconds, say so after the name: "
                        "--time \"NAME [ms]\"");
  }
}

void TimeColumn::take_numbers(TimesOfRows& out) {
  const std::optional<DateCount> count = date_count(seconds_, unit_s_, seconds_only_);
  if (!count && take_digits(out)) return;
  if (count && count->open) {
    out.doubt = doubt_of_days(
        number(seconds_.front(), 9) + " and numbers " + number(median_step(seconds_)) +
        " apart, which may be seconds of a day or days as Excel counts them");
    return;
  }
  double scale = count ? count->unit_s : unit_s_ > 0 ? unit_s_ : 1;
  if (!count && unit_s_ == 0) take_bare(out, scale);
  if (count) {
    out.dated = true;
    out.zoned = count->zoned;
    if (!count->note.empty()) out.notes.emplace_back(count->note);
  }
  if (scale == 1) {
    out.t = std::move(seconds_);
    return;
  }
  if (!count && take_rounded_count(seconds_, scale, out)) return;
  const double first = seconds_.front();
  const double origin = count ? first : 0;
  if (count) {
    const double day_units = kDayS / scale;
    const double day = std::floor((first - count->from_1970) / day_units);
    out.origin_day = static_cast<std::int32_t>(day);
    out.origin_seconds = (first - count->from_1970 - day * day_units) * scale;
    if (count->days) out.origin_seconds = std::round(out.origin_seconds * 1e3) / 1e3;
  }
  for (double& value : seconds_) {
    value = (value - origin) * scale;
    if (count) value = std::round(value * count->ticks) / count->ticks;
  }
  if (count && count->days) round_to_seconds(seconds_, out.origin_seconds);
  out.t = std::move(seconds_);
}

// Of times that are two numbers; the others count hours.
bool TimeColumn::minutes_and_seconds(TimesOfRows& out) const {
  if (!short_clocks_) return false;
  if (unit_given_ && (unit_s_ == 1 || unit_s_ == 60)) return unit_s_ == 1;
  if (decimals_ || *std::ranges::max_element(seconds_) > kDayS) {
    out.notes.emplace_back("the times are taken as minutes and seconds");
    return true;
  }
  if (elapsed_) {
    out.doubt = doubt_of_clock("time elapsed in two numbers, min:s or h:min");
    return false;
  }
  const bool repeat = std::ranges::adjacent_find(seconds_) != seconds_.end();
  if (!repeat) {
    out.notes.emplace_back(
        "the times are taken as hours and minutes; where they are minutes and seconds, "
        "say so after the name: --time \"NAME [s]\"");
  }
  return false;
}

void TimeColumn::take_clock(TimesOfRows& out) {
  const bool minutes = minutes_and_seconds(out);
  if (minutes) {
    for (double& value : seconds_) value /= 60;
  }
  std::size_t rising = 0;
  std::size_t falling = 0;  // of stamps cut to minutes, most do neither
  for (std::size_t i = 1; i < seconds_.size(); ++i) {
    if (seconds_[i] > seconds_[i - 1]) ++rising;
    if (seconds_[i] < seconds_[i - 1]) ++falling;
  }
  const double turn = (minutes ? kHourS : kDayS) * (rising >= falling ? 1 : -1);
  std::size_t turns = 0;
  double shift = 0;
  const double first = seconds_.front();
  out.time_of_day = !minutes;
  out.origin_seconds = first;
  out.t.reserve(seconds_.size());
  for (std::size_t i = 0; i < seconds_.size(); ++i) {
    // More than half a turn against the direction of time: a new day, or hour.
    if (i > 0 && (seconds_[i - 1] - seconds_[i]) / turn > 0.5) {
      shift += turn;
      ++turns;
    }
    out.t.push_back(tidy(seconds_[i] - first + shift));
  }
  if (turns == 0) return;
  const std::string times = std::to_string(turns) + (turns == 1 ? " time" : " times");
  out.notes.push_back(
      minutes
          ? "the times pass the full hour " + times + ": taken as the following hour"
          : "the time of day passes midnight " + times + ": taken as the following day");
}

}  // namespace workbench
