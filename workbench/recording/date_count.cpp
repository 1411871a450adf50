#include "workbench/recording/date_count.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "workbench/recording/statistics.hpp"

namespace workbench {
namespace {

constexpr double kDayS = 86400;
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

}  // namespace workbench
