#include "workbench/recording/written_time.hpp"

#include <chrono>
#include <cstddef>

#include "workbench/recording/letters.hpp"
#include "workbench/recording/times/time_spelling.hpp"
#include "workbench/recording/written_zone.hpp"

namespace workbench {
namespace {

int with_century(int year) {
  return year + (year < 70 ? 2000 : 1900);
}

struct Number {
  int value = 0;
  std::size_t digits = 0;
};

constexpr std::size_t kMostHourDigits = 4;

class TimeText {
 public:
  TimeText(std::string_view text, std::optional<DateOrder> order)
      : text_(text), order_(order) {}

  std::optional<WrittenTime> read() {
    if (text_.size() < 4 || text_.size() > 80) return std::nullopt;
    skip_weekday();
    const bool days = skip_days_elapsed();
    const bool clock_only = clock_is_next(kMostHourDigits);
    if (days && !clock_only) return std::nullopt;
    alone_ = clock_only;
    if (!clock_only && !read_date()) return std::nullopt;
    if (!clock_only) skip_between();
    if (at_ < text_.size() && !out_.has_clock && !read_clock()) return std::nullopt;
    if (!read_zone() || !read_late_year()) return std::nullopt;
    skip_blanks();
    if (at_ != text_.size()) return std::nullopt;
    out_.seconds += 86400.0 * days_elapsed_ - 60.0 * out_.zone_min;
    return out_;
  }

 private:
  [[nodiscard]] char peek(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }
  void skip_blanks() {
    while (peek() == ' ' || peek() == '\t') ++at_;
  }

  Number take_number(std::size_t most) {
    Number number;
    while (number.digits < most && is_digit(peek())) {
      number.value = 10 * number.value + (peek() - '0');
      ++number.digits;
      ++at_;
    }
    return number;
  }

  std::string take_word() {
    std::string lower;
    while (is_letter_byte(peek()) && lower.size() < 16) {
      const char c = text_[at_++];
      lower += c == '\xC4' ? '\xE4'  // Latin-1
               : c == '\x84' && !lower.empty() && lower.back() == '\xC3' ? '\xA4'
                                                                         : lower_case(c);
    }
    return lower;
  }

  void skip_weekday() {
    const std::size_t start = at_;
    const std::string word = take_word();
    if (word.empty() || !is_weekday(word)) {
      at_ = start;
      return;
    }
    while (peek() == '.' || peek() == ',' || peek() == ' ') ++at_;
  }

  [[nodiscard]] bool clock_is_next(std::size_t most_digits = 2) const {
    std::size_t digits = 0;
    while (digits < most_digits && is_digit(peek(digits))) ++digits;
    return digits > 0 && peek(digits) == ':';
  }

  // "4 days " as before a clock.
  bool skip_days_elapsed() {
    const std::size_t start = at_;
    const Number days = take_number(5);
    skip_blanks();
    const std::string word = days.digits > 0 ? take_word() : "";
    if (word != "day" && word != "days" && word != "d") {
      at_ = start;
      return false;
    }
    if (peek() == ',') ++at_;
    skip_blanks();
    days_elapsed_ = days.value;
    return true;
  }

  bool read_date() {
    if (is_letter_byte(peek())) return read_month_first();
    std::size_t digits = 0;
    while (is_digit(peek(digits))) ++digits;
    if (digits == 8 || digits == 12 || digits == 14 || digits == 17) {
      return read_compact(digits);
    }
    const Number first = take_number(4);
    if (first.digits == 0) return false;
    const char mark = peek();
    if (mark != '-' && mark != '/' && mark != '.' && mark != ' ') return false;
    ++at_;
    skip_blanks();
    if (is_letter_byte(peek())) return read_named_month(first, mark);
    if (mark == ' ') return false;
    const Number second = take_number(first.digits == 4 && mark != '.' ? 3 : 2);
    if (second.digits == 3) return know_day_of_year(first.value, second.value);
    if (second.digits == 0 || peek() != mark) return false;
    ++at_;
    if (mark == '.') skip_blanks();
    const Number third = take_number(4);
    if (first.digits == 4) {
      if (mark == '.' && peek() == '.') ++at_;  // 2026. 05. 13. 14:30
      return third.digits >= 1 && third.digits <= 2 &&
             know(first.value, second.value, third.value);
    }
    if (third.digits != 2 && third.digits != 4) return false;
    return know_or_wait(first, second, third, mark);
  }

  bool know_or_wait(const Number& first, const Number& second, const Number& third,
                    char mark) {
    if (first.digits > 2) return false;
    out_.kind =
        third.digits == 4 ? WrittenTime::Day::kYearLast : WrittenTime::Day::kAllTwoDigits;
    out_.numbers = static_cast<std::uint32_t>(first.value) << 24 |
                   static_cast<std::uint32_t>(second.value) << 16 |
                   static_cast<std::uint32_t>(third.value);
    std::optional<DateOrder> order = order_;
    if (out_.kind == WrittenTime::Day::kYearLast && order == DateOrder::ymd)
      order.reset();
    // Dots stand in dates that begin with the day.
    if (!order && mark == '.') order = DateOrder::dmy;
    if (!order) {
      for (const DateOrder any : kDateOrders) {
        if (day_of(out_.numbers, out_.kind, any)) return true;
      }
      return false;
    }
    const std::optional<std::int32_t> day = day_of(out_.numbers, out_.kind, *order);
    if (!day) return false;
    out_.kind = WrittenTime::Day::kKnown;
    out_.day = *day;
    return true;
  }

  bool read_compact(std::size_t digits) {
    const int year = take_number(4).value;
    const int month = take_number(2).value;
    const int day = take_number(2).value;
    if (year < 1970 || year > 2199 || !know(year, month, day)) return false;
    if (digits >= 12) return read_compact_clock(digits, year);
    if (peek() == 'T' && is_digit(peek(1))) {
      ++at_;
      const Number hour = take_number(2);
      if (peek() == ':') {
        at_ -= hour.digits;
        return true;
      }
      const Number minute = take_number(2);
      const Number second = take_number(2);
      return minute.digits == 2 && set_clock(hour.value, minute.value, second.value) &&
             read_fraction();
    }
    return peek() != '\0';  // eight digits alone are a number
  }

  // Behind a date of eight digits: HHmm, HHmmss, perhaps with decimals, or HHmmssfff.
  bool read_compact_clock(std::size_t digits, int year) {
    // Of 2001 to 2012 the twelve digits may be yyMMddHHmmss as well.
    const bool open = digits == 12 && ((year > 2000 && year < 2013) || year > 2099);
    const int hour = take_number(2).value;
    const int minute = take_number(2).value;
    if (open || !set_clock(hour, minute, digits > 12 ? take_number(2).value : 0)) {
      return false;
    }
    if (digits == 17) out_.seconds += 1e-3 * take_number(3).value;
    return digits != 14 || read_fraction();
  }

  // 03-May-26, 3. Mai 2026, 2026-May-03
  bool read_named_month(const Number& first, char mark) {
    const int month = month_named(take_word());
    if (month == 0) return false;
    while (peek() == mark || peek() == '.' || peek() == ' ' || peek() == ',') ++at_;
    const Number last = take_number(4);
    if (first.digits == 4) {
      return last.digits >= 1 && last.digits <= 2 && know(first.value, month, last.value);
    }
    return (last.digits == 2 || last.digits == 4) &&
           know(full_year(last), month, first.value);
  }

  // May 3, 2026 or May 03 14:30:00 CEST 2026
  bool read_month_first() {
    const int month = month_named(take_word());
    if (month == 0) return false;
    while (peek() == '.' || peek() == ' ' || peek() == '-' || peek() == '/') ++at_;
    const Number day = take_number(2);
    if (day.digits == 0) return false;
    while (peek() == ',' || peek() == ' ' || peek() == '-' || peek() == '/') ++at_;
    if (clock_is_next()) {
      late_month_ = month;
      late_day_ = day.value;
      return read_clock();
    }
    const Number year = take_number(4);
    return (year.digits == 2 || year.digits == 4) &&
           know(full_year(year), month, day.value);
  }

  static int full_year(const Number& year) {
    return year.digits == 4 ? year.value : with_century(year.value);
  }

  bool read_late_year() {
    if (late_month_ == 0) return true;
    skip_blanks();
    const Number year = take_number(4);
    return year.digits == 4 && know(year.value, late_month_, late_day_);
  }

  bool know(int year, int month, int day) {
    const std::optional<std::int32_t> number = day_number(year, month, day);
    if (!number) return false;
    out_.kind = WrittenTime::Day::kKnown;
    out_.day = *number;
    return true;
  }

  bool know_day_of_year(int year, int day) {
    if (year < 1970 || year > 2199 || day < 1 || !know(year, 1, 1)) return false;
    out_.day += day - 1;
    return out_.day <= day_number(year, 12, 31);
  }

  void skip_between() {
    if (peek() == ',' || peek() == ';') ++at_;
    if ((peek() == 'T' || peek() == 't' || peek() == '_' || peek() == '-') &&
        is_digit(peek(1))) {
      ++at_;
    }
    skip_blanks();
  }

  bool read_clock() {
    const Number hour = take_number(alone_ ? kMostHourDigits : 2);
    if (hour.digits == 0 || peek() != ':') return false;
    ++at_;
    const Number minute = take_number(2);
    if (minute.digits == 0) return false;
    Number second;
    if (peek() == ':') {
      ++at_;
      second = take_number(2);
      if (second.digits == 0) return false;
    }
    if (!set_clock(hour.value, minute.value, second.value)) return false;
    out_.short_clock = alone_ && second.digits == 0;
    if (!read_fraction()) return false;
    const std::size_t whole = at_;
    if (!read_half_day(hour.value)) return false;
    out_.short_clock = out_.short_clock && at_ == whole;
    return true;
  }

  bool set_clock(int hour, int minute, int second) {
    if (minute > 59 || second > 60) return false;
    if (!alone_ && (hour > 24 || (hour == 24 && minute + second > 0))) return false;
    out_.has_clock = true;
    out_.seconds = 3600.0 * hour + 60.0 * minute + second;
    return true;
  }

  bool read_fraction() {
    const char mark = peek();
    const bool counts = mark == ':' || mark == ';';
    if ((mark != '.' && mark != ',' && !counts) || !is_digit(peek(1))) return true;
    ++at_;
    if (counts) {  // hh:mm:ss:mmm, and hh:mm:ss;m of Studio 5000, count milliseconds
      out_.seconds += 1e-3 * take_number(3).value;
      return true;
    }
    double digits = 0;
    double unit = 1;
    while (is_digit(peek())) {
      digits = 10 * digits + (peek() - '0');
      unit *= 10;
      ++at_;
    }
    out_.decimal = out_.short_clock;
    out_.seconds += digits / unit * (out_.short_clock ? 60 : 1);
    return true;
  }

  bool read_half_day(int hour) {
    const std::size_t start = at_;
    skip_blanks();
    const char half = static_cast<char>(peek() | 0x20);
    const std::size_t dot = peek(1) == '.' ? 1 : 0;
    if ((half != 'a' && half != 'p') || (peek(1 + dot) | 0x20) != 'm') {
      at_ = text_.substr(at_) == "Uhr" ? text_.size() : start;
      return true;
    }
    if (hour < 1 || hour > 12) return false;
    at_ += 2 + dot;
    if (peek() == '.') ++at_;
    if (half == 'a' && hour == 12) out_.seconds -= 43200;
    if (half == 'p' && hour != 12) out_.seconds += 43200;
    return true;
  }

  bool read_zone() {
    if (!out_.has_clock) return true;
    skip_blanks();
    const std::optional<WrittenZone> zone = written_zone(text_.substr(at_));
    if (!zone || (alone_ && !zone->unknown.empty())) return false;
    at_ += zone->length;
    out_.has_zone = zone->minutes.has_value();
    out_.zone_min = static_cast<std::int16_t>(zone->minutes.value_or(0));
    out_.open_zone = zone->open;
    out_.zone_word = zone->unknown;
    return true;
  }

  std::string_view text_;
  std::optional<DateOrder> order_;
  std::size_t at_ = 0;
  bool alone_ = false;  // a clock without date: it may be time elapsed
  int days_elapsed_ = 0;
  int late_month_ = 0;
  int late_day_ = 0;
  WrittenTime out_;
};

}  // namespace

std::optional<WrittenTime> written_time(std::string_view cell,
                                        std::optional<DateOrder> order) {
  const std::optional<WrittenTime> time = TimeText(cell, order).read();
  if (time) return time;
  const std::optional<std::string> plain = plain_time(cell);
  return plain ? TimeText(*plain, order).read() : std::nullopt;
}

std::optional<std::int32_t> day_number(int year, int month, int day) {
  if (year < 1 || year > 9999 || month < 1 || day < 1) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(year),
                                         std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (month > 12 || day > 31 || !date.ok()) return std::nullopt;
  return std::chrono::sys_days(date).time_since_epoch().count();
}

std::optional<std::int32_t> day_of(std::uint32_t numbers, WrittenTime::Day kind,
                                   DateOrder order) {
  const int first = static_cast<int>(numbers >> 24);
  const int second = static_cast<int>(numbers >> 16 & 0xFF);
  const int third = static_cast<int>(numbers & 0xFFFF);
  if (order == DateOrder::ymd) {
    if (kind == WrittenTime::Day::kYearLast) return std::nullopt;
    return day_number(with_century(first), second, third);
  }
  const int year = kind == WrittenTime::Day::kYearLast ? third : with_century(third);
  return order == DateOrder::dmy ? day_number(year, second, first)
                                 : day_number(year, first, second);
}

}  // namespace workbench
