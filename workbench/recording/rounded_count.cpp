#include "workbench/recording/rounded_count.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "workbench/recording/clock_digits.hpp"
#include "workbench/recording/date_count.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

constexpr double kMinuteS = 60;
constexpr double kDayS = 86400;
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

std::optional<RoundedCount> rounded_count(const std::vector<double>& values,
                                          double unit_s) {
  constexpr std::size_t kFewest = 20;
  constexpr double kSure = 0.05;  // of a second, by which the spacing may be off
  if (unit_s < kMinuteS || values.size() < kFewest) return std::nullopt;
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
