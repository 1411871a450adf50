#include "firmware/band_trend.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "wire/calendar.hpp"

namespace firmware {
namespace {

constexpr double kResolution = 0.01;  // % of span, of a row of the history
constexpr double kNormal95 = 1.959964;
constexpr double kNormal998 = 3.090232;

// Student's quantile from the normal one (Cornish and Fisher), for 4 and more degrees.
double student(double z, double degrees) {
  const double z3 = z * z * z;
  const double z5 = z3 * z * z;
  const double z7 = z5 * z * z;
  return z + (z3 + z) / (4 * degrees) +
         (5 * z5 + 16 * z3 + 3 * z) / (96 * degrees * degrees) +
         (3 * z7 + 19 * z5 + 17 * z3 - 15 * z) / (384 * degrees * degrees * degrees);
}

struct Week {
  double days = 0;  // with windows
  double at = 0;    // their mean day, before the newest: ≤ 0
  double band = 0;  // their mean
};

using Weeks = std::array<Week, BandTrend::kWeeks>;

struct Line {
  double weight = 0;
  double at = 0;  // weighted means
  double band = 0;
  double spread = 0;  // Σ w (at − mean)²
  double slope = 0;
  [[nodiscard]] double value(double t) const { return band + slope * (t - at); }
};

Line line_through(const Weeks& weeks) {
  Line line;
  for (const Week& week : weeks) {
    line.weight += week.days;
    line.at += week.days * week.at;
    line.band += week.days * week.band;
  }
  line.at /= line.weight;
  line.band /= line.weight;
  double product = 0;
  for (const Week& week : weeks) {
    const double t = week.at - line.at;
    line.spread += week.days * t * t;
    product += week.days * t * (week.band - line.band);
  }
  line.slope = product / line.spread;
  return line;
}

// Correlation of neighbouring weeks' residuals, as of many weeks: that of few, about a
// line, is too low by (1 + 4r)/n and 1/n more.
double dependence(const Weeks& weeks, const Line& line, int count) {
  double square = 0;
  double product = 0;
  double before = 0;
  bool next = false;
  for (const Week& week : weeks) {
    if (week.days <= 0) {
      next = false;
      continue;
    }
    const double off = week.band - line.value(week.at);
    square += off * off;
    if (next) product += off * before;
    before = off;
    next = true;
  }
  if (!(square > 0)) return 0;
  const double r = product / square;
  return std::clamp(r + (2 + 4 * r) / count, 0.0, 0.8);
}

double days_to(double gap, double slope) {
  if (gap <= 0) return 0;
  return slope > 0 ? gap / slope : wire::kNotAvailable;
}

}  // namespace

void BandTrend::add(std::int64_t epoch_s, double band_pct) {
  if (epoch_s < 0 || !std::isfinite(band_pct)) return;
  const auto day = static_cast<std::int32_t>(epoch_s / wire::kDayS);
  Day& entry = days_[static_cast<std::size_t>(day % kDays)];
  if (entry.day > day) return;
  if (entry.day < day) entry = {day, 0, 0};
  ++entry.windows;
  entry.mean +=
      (static_cast<float>(band_pct) - entry.mean) / static_cast<float>(entry.windows);
}

Trend BandTrend::find(std::int64_t epoch_s, double limit_pct) const {
  const auto today = static_cast<std::int32_t>(epoch_s / wire::kDayS);
  Trend trend = fit(today);
  const Trend before = fit(today - kConfirmDays);
  trend.stands = trend.stands && before.stands && trend.slope * before.slope > 0;
  if (trend.stands) {
    const double gap = limit_pct - trend.band_pct;
    trend.days = days_to(gap, trend.slope);
    trend.days_early = days_to(gap, trend.high);
    trend.days_late = days_to(gap, trend.low);
  }
  return trend;
}

Trend BandTrend::fit(std::int32_t today) const {
  Weeks weeks;
  for (const Day& entry : days_) {
    const std::int32_t age = today - entry.day;
    if (entry.day < 0 || age < 0 || age >= kDays) continue;
    Week& week = weeks[static_cast<std::size_t>(kWeeks - 1 - age / 7)];
    week.days += 1;
    week.at += (-age - week.at) / week.days;
    week.band += (static_cast<double>(entry.mean) - week.band) / week.days;
  }
  const auto count = static_cast<int>(
      std::ranges::count_if(weeks, [](const Week& week) { return week.days > 0; }));
  if (count < kFewestWeeks) return {};
  const Line line = line_through(weeks);
  double error = 0;
  for (const Week& week : weeks) {
    const double off = week.days > 0 ? week.band - line.value(week.at) : 0;
    error += week.days * off * off;
  }
  const double degrees = count - 2;
  const double variance =
      std::max(error / degrees, kResolution * kResolution) / line.spread;
  const double r = dependence(weeks, line, count);
  const double deviation = std::sqrt(variance * (1 + r) / (1 - r));
  Trend trend;
  trend.fitted = true;
  trend.slope = line.slope;
  const double half = student(kNormal95, degrees) * deviation;
  trend.low = trend.slope - half;
  trend.high = trend.slope + half;
  trend.stands = std::abs(trend.slope) > student(kNormal998, degrees) * deviation;
  trend.band_pct = line.value(0);
  return trend;
}

}  // namespace firmware
