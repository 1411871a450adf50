// Dates of a time column: the order of day and month that its rows leave.
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "workbench/recording/filled.hpp"
#include "workbench/recording/time_unit.hpp"
#include "workbench/recording/times/time_column.hpp"

namespace workbench {
namespace {

using Day = WrittenTime::Day;

}  // namespace

bool TimeColumn::add_day(const WrittenTime& time) {
  if (days_.empty()) {
    day_kind_ = time.kind;
  } else if (day_kind_ != time.kind) {
    return false;
  }
  const bool known = time.kind == Day::kKnown;
  days_.push_back(known ? static_cast<std::uint32_t>(time.day) : time.numbers);
  return true;
}

std::int32_t TimeColumn::day_at(std::size_t row, DateOrder order) const {
  if (day_kind_ == Day::kKnown) return static_cast<std::int32_t>(days_[row]);
  return day_of(days_[row], day_kind_, order).value_or(0);
}

bool TimeColumn::reads(DateOrder order) const {
  std::uint32_t last = 0;
  bool last_reads = false;
  for (const std::uint32_t numbers : days_) {
    if (last_reads && numbers == last) continue;
    last = numbers;
    last_reads = day_of(numbers, day_kind_, order).has_value();
    if (!last_reads) return false;
  }
  return true;
}

// Time moves in one direction, the hour of daylight saving aside.
bool TimeColumn::runs_on(DateOrder order) const {
  bool rises = false;
  bool falls = false;
  for (std::size_t i = 1; i < days_.size(); ++i) {
    if (days_[i] == days_[i - 1]) continue;
    const double step = (day_at(i, order) - day_at(i - 1, order)) * kDayS +
                        (seconds_[i] - seconds_[i - 1]);
    rises = rises || step > 2 * 3600;
    falls = falls || step < -2 * 3600;
    const bool day_rises = day_at(i, order) > day_at(i - 1, order);
    (day_rises ? rises : falls) = true;
  }
  return !(rises && falls);
}

double TimeColumn::longest_step_s(DateOrder order) const {
  double longest = 0;
  for (std::size_t i = 1; i < days_.size(); ++i) {
    if (days_[i] == days_[i - 1]) continue;
    const double step = (day_at(i, order) - day_at(i - 1, order)) * kDayS +
                        (seconds_[i] - seconds_[i - 1]);
    longest = std::max(longest, std::abs(step));
  }
  return longest;
}

// The readings that the rows leave, the better founded alone where one is.
std::vector<DateOrder> TimeColumn::orders() const {
  std::vector<DateOrder> left;
  for (const DateOrder order : kDateOrders) {
    if (reads(order)) left.push_back(order);
  }
  std::vector<DateOrder> running;
  std::ranges::copy_if(left, std::back_inserter(running),
                       [this](DateOrder order) { return runs_on(order); });
  if (!running.empty()) left = std::move(running);
  std::vector<DateOrder> continuous;
  std::ranges::copy_if(left, std::back_inserter(continuous),
                       [this](DateOrder order) { return longest_step_s(order) < kDayS; });
  if (!continuous.empty()) left = std::move(continuous);
  const auto same_days = [this](DateOrder a, DateOrder b) {
    for (std::size_t i = 0; i < days_.size(); ++i) {
      if (day_at(i, a) != day_at(i, b)) return false;
    }
    return true;
  };
  while (left.size() > 1 && same_days(left[0], left.back())) left.pop_back();
  return left;
}

std::optional<std::uint32_t> TimeColumn::one_open_day() const {
  const bool open =
      form_ == TimeForm::kDate && !days_.empty() && day_kind_ != Day::kKnown &&
      std::ranges::adjacent_find(days_, std::not_equal_to<>()) == days_.end();
  // The hour of daylight saving needs its date.
  const bool runs = open && (std::ranges::is_sorted(seconds_) ||
                             std::ranges::is_sorted(seconds_, std::greater<>()));
  return runs ? std::optional(days_.front()) : std::nullopt;
}

std::vector<TimeColumn::Reading> TimeColumn::ambiguity() const {
  std::vector<Reading> readings;
  if (form_ != TimeForm::kDate || days_.empty() || day_kind_ == Day::kKnown) {
    return readings;
  }
  const std::vector<DateOrder> left = orders();
  if (left.size() < 2 || one_open_day()) return readings;
  std::size_t row = 0;
  while (row + 1 < days_.size() && day_at(row, left[0]) == day_at(row, left[1])) ++row;
  for (const DateOrder order : left) {
    readings.push_back({order, date_text(day_at(row, order))});
  }
  return readings;
}

bool TimeColumn::unreadable() const {
  return form_ == TimeForm::kDate && !days_.empty() && day_kind_ != Day::kKnown &&
         orders().empty();
}

void TimeColumn::take_dates(TimesOfRows& out) {
  const DateOrder order = day_kind_ == Day::kKnown ? DateOrder::dmy : orders().front();
  const std::int32_t first_day = day_at(0, order);
  const double first = seconds_.front();
  out.t.reserve(seconds_.size());
  for (std::size_t i = 0; i < seconds_.size(); ++i) {
    out.t.push_back(tidy((day_at(i, order) - first_day) * kDayS + (seconds_[i] - first)));
  }
  if (!note_.empty()) out.notes.push_back(note_);
  if (!zone_word_.empty()) {
    out.notes.push_back("the zone " + zone_word_ +
                        " behind the times is not known: taken as local time");
    out.zone_word = zone_word_;
  }
  const std::vector<DateOrder> left =
      one_open_day() ? orders() : std::vector<DateOrder>{order};
  out.dated = left.size() == 1;
  if (!out.dated) {
    out.time_of_day = true;
    out.notes.push_back(
        filled("the date may be {0} or {1}: all times are of that day",
               {date_text(day_at(0, left.front())), date_text(day_at(0, left.back()))}));
  }
  out.zoned = has_zone_;
  out.zone_min = static_cast<std::int16_t>(first_zone_.minutes);
  out.open_zone = first_zone_.open;
  if (strange_zone_) {
    out.doubt = doubt_of_zones(zone_text(first_zone_), zone_text(*strange_zone_));
  }
  out.origin_day = first_day;
  out.origin_seconds = first;
}

}  // namespace workbench
