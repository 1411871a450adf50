#include "workbench/recording/times/date_count.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "workbench/recording/filled.hpp"
#include "workbench/recording/letters.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/recording/statistics.hpp"
#include "workbench/recording/time_unit.hpp"
#include "workbench/recording/times/clock_digits.hpp"

namespace workbench {
namespace {

constexpr double k1990 = 631152000;  // s from 1970
constexpr double k2000 = 946684800;
constexpr double k2060 = 2840140800;
constexpr double k2100 = 4102444800;
constexpr double kTickS = 1e-7;
constexpr double kFrom1601 = 11644473600;  // s to 1970
constexpr double kFrom0001 = 62135596800;
constexpr double kExcel1970 = 25569;  // days from 30 December 1899
constexpr double kExcelFirst = 20000;
constexpr double kExcelLast = 80000;
constexpr double kMatlab1970 = 719529;  // days from the year 0
constexpr double kMostStepDays = 1.0 / 48;
constexpr double kLoggerTickS = 1e-3;  // loggers count seconds in these
constexpr double kDayTicks = 1e4;      // ten digits of a day are 10 µs

bool all_within(const std::vector<double>& values, double low, double high) {
  return std::ranges::all_of(values, [=](double v) { return v >= low && v < high; });
}

bool all_between(const std::vector<double>& values, const DateCount& count, double first,
                 double last) {
  return all_within(values, count.from_1970 + first / count.unit_s,
                    count.from_1970 + last / count.unit_s);
}

bool is_whole(double value) {
  constexpr double kRounding = 0.02;
  return value > 0.5 && std::abs(value - std::round(value)) < kRounding;
}

// A step that makes sense in days, and none in seconds.
bool steps_in_days(double step) {
  constexpr double kFinestS = 1e-4;
  return step < kMostStepDays && is_whole(step * kDayS) && !is_whole(step / kFinestS);
}

constexpr std::int32_t kExcel2000 = 36526;
constexpr std::int32_t kExcel2100 = 73051;

// The digits before decimals that are zero.
std::string_view whole_digits(std::string_view cell) {
  const std::size_t mark = cell.find_first_of(".,");
  const std::string_view whole = cell.substr(0, mark);
  const std::string_view behind =
      mark == std::string_view::npos ? "" : cell.substr(mark + 1);
  const bool zeros = behind.find_first_not_of('0') == std::string_view::npos;
  return zeros && std::ranges::all_of(whole, is_digit) ? whole : "";
}

constexpr double kRounding = 1e-3;

// What the last decimal of the numbers counts; 0: there are more than nine.
double last_digit(const std::vector<double>& values) {
  constexpr int kMostDigits = 9;
  double parts = 1;
  for (int digits = 0; digits <= kMostDigits; ++digits, parts *= 10) {
    const bool whole = std::ranges::all_of(values, [parts](double v) {
      return std::abs(v * parts - std::round(v * parts)) < kRounding;
    });
    if (whole) return 1 / parts;
  }
  return 0;
}

// Steps that are alike to a thousandth and no half seconds of a day, as of a fast
// sampler.
bool are_alike_in_seconds(const std::vector<double>& values, double step) {
  const bool alike = std::ranges::adjacent_find(values, [step](double a, double b) {
                       return std::abs(b - a - step) > kRounding * step;
                     }) == values.end();
  const double halves = 2 * step * kDayS;
  return alike && std::abs(halves - std::round(halves)) > kRounding * halves;
}

}  // namespace

double median_step(const std::vector<double>& values) {
  std::vector<double> steps;
  steps.reserve(values.size());
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i] != values[i - 1]) steps.push_back(std::abs(values[i] - values[i - 1]));
  }
  if (steps.empty()) return 0;
  return of_rank(steps, steps.size() / 2);
}

std::optional<DateCount> date_count(const std::vector<double>& values, double unit_s,
                                    bool seconds_only) {
  for (const double unit : {1.0, 1e-3, 1e-6, 1e-9}) {
    if (unit_s > 0 && unit_s != unit) continue;
    const DateCount count{unit, 0, 1 / std::min(unit * 1e-3, 1e-3), false, true};
    if (all_between(values, count, k2000, k2100)) return count;
  }
  if (unit_s > 0 && unit_s != kDayS) return std::nullopt;
  constexpr double kTicks = 1e5;
  const DateCount windows{
      kTickS, kFrom1601 / kTickS,
      kTicks, false,
      true,   "the times are 100 ns as Windows counts them, from 1601"};
  const DateCount net{
      kTickS, kFrom0001 / kTickS,
      kTicks, false,
      false,  "the times are 100 ns as .NET counts them, from the year 1"};
  for (const DateCount& count : {windows, net}) {
    if (unit_s == 0 && all_between(values, count, k1990, k2060)) return count;
  }
  const DateCount excel{kDayS, kExcel1970, kDayTicks,
                        true,  false,      "the times are days as Excel counts them"};
  const DateCount matlab{kDayS, kMatlab1970, kDayTicks,
                         true,  false,       "the times are days as MATLAB counts them"};
  if (all_within(values, kExcelFirst, kExcelLast)) {
    const double step = median_step(values);
    const bool fits = seconds_only ? steps_in_days(step) : step < kMostStepDays;
    // 30000.02: the seconds of a day, 50 a second, step like no clock in days.
    const bool open =
        unit_s == 0 && !steps_in_days(step) && is_whole(step / kLoggerTickS);
    if (fits && open) return DateCount{.open = true};
    if (fits) return excel;
  }
  if (all_between(values, matlab, k1990, k2060) && steps_in_days(median_step(values))) {
    return matlab;
  }
  return std::nullopt;
}

std::optional<WrittenTime> date_digits(std::string_view cell,
                                       std::optional<DateOrder> order) {
  const std::string text(whole_digits(cell));
  if (text.size() == 8) {
    return written_time(text.substr(0, 4) + '-' + text.substr(4, 2) + '-' +
                        text.substr(6));
  }
  if (text.size() == 6) {
    return written_time(
        text.substr(0, 2) + '/' + text.substr(2, 2) + '/' + text.substr(4), order);
  }
  if (text.size() != 5) return std::nullopt;
  const std::int32_t day = std::stoi(text);
  if (day < kExcel2000 || day >= kExcel2100) return std::nullopt;
  WrittenTime out;
  out.kind = WrittenTime::Day::kKnown;
  out.day = day - static_cast<std::int32_t>(kExcel1970);
  return out;
}

std::optional<RoundedCount> rounded_count(const std::vector<double>& values,
                                          double unit_s) {
  constexpr std::size_t kFewest = 20;
  constexpr double kSure = 0.05;  // of a second, by which the spacing may be off
  if (unit_s < 60 || values.size() < kFewest) return std::nullopt;
  const auto steps = static_cast<double>(values.size() - 1);
  RoundedCount out;
  out.digit_s = last_digit(values) * unit_s;
  out.period_s = std::round((values.back() - values.front()) * unit_s / steps);
  const double period = std::abs(out.period_s);
  if (period < 1 || out.digit_s < kRounding * period || out.digit_s > kSure * steps) {
    return std::nullopt;
  }
  double least = 0;
  double most = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double line = out.period_s * static_cast<double>(i);
    const double off = (values[i] - values.front()) * unit_s - line;
    least = std::min(least, off);
    most = std::max(most, off);
    out.t.push_back(values.front() * unit_s + line);
  }
  if (most - least > (1 + kRounding) * out.digit_s) return std::nullopt;
  return out;
}

bool take_rounded_count(const std::vector<double>& values, double unit_s,
                        TimesOfRows& out) {
  std::optional<RoundedCount> rounded = rounded_count(values, unit_s);
  if (!rounded) return false;
  out.notes.push_back(
      filled("the times are rounded to {0} s: taken as {1} s apart",
             {number(rounded->digit_s), number(std::abs(rounded->period_s))}));
  out.t = std::move(rounded->t);
  return true;
}

bool are_rounded_days(const std::vector<double>& values) {
  const std::optional<RoundedCount> count = rounded_count(values, kDayS);
  return count && is_step_in_days(std::abs(count->period_s) / kDayS);
}

bool may_be_parts_of_day(const std::vector<double>& values) {
  constexpr double kShortest = 1e-3;
  const double step = median_step(values);
  return step > 0 && step < kShortest && !are_alike_in_seconds(values, step) &&
         std::ranges::all_of(values, [](double v) { return v >= 0 && v < 1; });
}

}  // namespace workbench
