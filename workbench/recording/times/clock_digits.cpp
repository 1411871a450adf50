#include "workbench/recording/times/clock_digits.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "workbench/recording/statistics.hpp"
#include "workbench/recording/time_unit.hpp"
#include "workbench/recording/times/date_count.hpp"
#include "workbench/recording/written_time.hpp"

namespace workbench {
namespace {

constexpr double kLastHhmm = 2400;

struct Read {
  double seconds;  // of the day, or from 1970 with a date
  bool valid;
};

Read with_date(double date, double seconds) {
  const auto digits = static_cast<long long>(date);
  const std::optional<std::int32_t> day =
      day_number(static_cast<int>(2000 + digits / 10000),
                 static_cast<int>(digits / 100 % 100), static_cast<int>(digits % 100));
  return {day.value_or(0) * kDayS + seconds, day.has_value()};
}

Read read(double number) {
  if (!(number >= 0) || number >= 1e12) return {0, false};
  const double minutes = std::floor(number / 100);
  const double hours = std::floor(minutes / 100);
  const double date = std::floor(hours / 100);
  const double s = number - 100 * minutes;
  const double m = minutes - 100 * hours;
  const double h = hours - 100 * date;
  if (s >= 60 || m >= 60 || h >= 24) return {0, false};
  const double seconds = kHourS * h + 60 * m + s;
  return date > 0 ? with_date(date, seconds) : Read{seconds, true};
}

// Whether each full minute makes the numbers jump while the clock goes on as before.
bool goes_on(const std::vector<double>& numbers, const std::vector<double>& t) {
  constexpr std::size_t kFewest = 3;
  constexpr double kMost = 0.9;
  constexpr double kAsUsual = 1.01;
  double longest = 0;
  std::vector<double> steps;
  for (std::size_t i = 1; i < t.size(); ++i) {
    if (std::floor(numbers[i] / 100) != std::floor(numbers[i - 1] / 100)) continue;
    longest = std::max(longest, t[i] - t[i - 1]);
    steps.push_back(t[i] - t[i - 1]);
  }
  if (steps.size() < kFewest) return false;
  const double usual = of_rank(steps, steps.size() / 2);
  std::size_t passed = 0;
  std::size_t as_before = 0;
  for (std::size_t i = 1; i < t.size(); ++i) {
    if (std::floor(numbers[i] / 100) == std::floor(numbers[i - 1] / 100)) continue;
    ++passed;
    const double gone = t[i] - t[i - 1];
    const bool jumps =
        numbers[i] < numbers[i - 1] || numbers[i] - numbers[i - 1] > kAsUsual * usual;
    if (jumps && gone > 0 && gone <= kAsUsual * longest) ++as_before;
  }
  return passed >= kFewest &&
         static_cast<double>(as_before) >= kMost * static_cast<double>(passed);
}

}  // namespace

std::optional<ClockDigits> clock_digits(const std::vector<double>& numbers,
                                        bool to_minutes) {
  if (numbers.empty()) return std::nullopt;
  ClockDigits out;
  const double largest = *std::ranges::max_element(numbers);
  if (to_minutes && largest >= kLastHhmm) return std::nullopt;
  const bool dated = largest >= 1e6;
  // Read as MMSS, hours and minutes pass a day in as many seconds as it has minutes.
  const double turn = to_minutes ? kDayS / 60 : largest < 6000 ? kHourS : kDayS;
  double shift = 0;
  for (const double number : numbers) {
    const Read time = read(number);
    if (!time.valid) return std::nullopt;
    if (!dated && !out.t.empty() && out.t.back() - shift - time.seconds > turn / 2) {
      shift += turn;
    }
    out.t.push_back(time.seconds + shift);
  }
  if (!goes_on(numbers, out.t)) return std::nullopt;
  const double unit_s = to_minutes ? 60 : 1;
  const double first = out.t.front() * unit_s;
  for (double& t : out.t) t = t * unit_s - first;
  out.open = !to_minutes && largest < kLastHhmm;
  out.form = dated            ? "yyMMddHHMMSS"
             : to_minutes     ? "HHMM"
             : turn == kHourS ? "MMSS"
                              : "HHMMSS";
  out.first_s = dated ? std::fmod(first, kDayS) : first;
  if (dated) out.day = static_cast<std::int32_t>(std::floor(first / kDayS));
  return out;
}

std::optional<DayTimes> times_of_day(const std::vector<double>& numbers,
                                     std::size_t most_digits, bool passes_days) {
  if (numbers.empty()) return std::nullopt;
  const auto [lowest, highest] = std::ranges::minmax_element(numbers);
  DayTimes out;
  if (*lowest >= 0 && *highest < 1 && is_step_in_days(median_step(numbers))) {
    out.form = "fractions of a day";
    for (const double number : numbers) {
      out.seconds.push_back(std::round(number * kDayS * 1e3) / 1e3);
    }
    return out;
  }
  const bool short_numbers = *highest < kLastHhmm && most_digits <= 4;
  if (short_numbers && !passes_days) return std::nullopt;
  out.form = short_numbers ? "HHMM" : "HHMMSS";
  for (const double number : numbers) {
    const Read time = read(short_numbers ? 100 * number : number);
    if (!time.valid || time.seconds >= kDayS) return std::nullopt;
    out.seconds.push_back(time.seconds);
  }
  return out;
}

bool is_step_in_days(double step) {
  constexpr double kExact = 1e-3;
  for (const double seconds : {1., 2., 5., 10., 15., 20., 30., 60.}) {
    if (std::abs(step * kDayS - seconds) <= kExact * seconds) return true;
  }
  return false;
}

bool is_unusual_step(double step) {
  constexpr double kUsual[] = {5,   6,   10,  15,  20,  30,   60,   120,  180, 240,
                               300, 360, 600, 720, 900, 1200, 1800, 3600, 7200};
  return step >= kUsual[0] && step == std::round(step) &&
         std::find(std::begin(kUsual), std::end(kUsual), step) == std::end(kUsual);
}

bool is_uneven_count(std::span<const double> times) {
  constexpr double kLongest = 4;
  constexpr double kMostUsual = 0.9;
  std::map<double, std::size_t> steps;
  for (std::size_t k = 1; k < times.size(); ++k) {
    const double step = times[k] - times[k - 1];
    if (step != std::round(step) || step < 1 || step > kLongest) return false;
    ++steps[step];
  }
  const double all = static_cast<double>(times.size()) - 1;
  return !steps.empty() && std::ranges::none_of(steps, [all](const auto& step) {
    return static_cast<double>(step.second) > kMostUsual * all;
  });
}

}  // namespace workbench
