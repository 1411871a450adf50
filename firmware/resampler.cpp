#include "firmware/resampler.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace firmware {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kForget = 1.0 / 16;  // weight of the newest arrival
constexpr double kSharp = 0.8;       // length of the mean phase vector of a cyclic signal
constexpr int kArrivalsToStart = 4;  // of u and of y
constexpr int kPeriodsToStart = 8;   // at the latest
constexpr int kMostArrivals = 1 << 20;
constexpr double kComfortable = 0.2;       // periods between an arrival and an instant
constexpr std::int64_t kMostStale = 1000;  // void instants in a row that are given
constexpr double kLate = 1.1;              // intervals until a value has missed its turn

double wrapped(double cycles) {
  return cycles - std::round(cycles);
}

}  // namespace

Resampler::Resampler(std::int64_t period_us, std::int64_t stale_after_us)
    : period_us_(std::max<std::int64_t>(period_us, 1)), stale_after_us_(stale_after_us) {}

bool Resampler::Series::cyclic() const {
  return arrivals >= kArrivalsToStart && std::hypot(cosine, sine) > kSharp;
}

double Resampler::Series::phase() const {
  const double turns = std::atan2(sine, cosine) / kTurn;
  return turns < 0 ? turns + 1 : turns;
}

void Resampler::take(Channel channel, std::int64_t t_us, double value) {
  if (!any_) {
    any_ = true;
    first_us_ = instant_us_ = t_us;
  }
  Series& series = series_[static_cast<std::size_t>(channel)];
  const double angle = kTurn * wrapped(static_cast<double>(t_us - instant_us_) /
                                       static_cast<double>(period_us_));
  const double weight = std::max(kForget, 1.0 / (series.arrivals + 1));
  series.cosine += weight * (std::cos(angle) - series.cosine);
  series.sine += weight * (std::sin(angle) - series.sine);
  if (series.present && t_us > series.t_us) {
    const std::int64_t interval_us = t_us - series.t_us;
    series.shortest_us =
        series.shortest_us == 0 ? interval_us : std::min(series.shortest_us, interval_us);
    series.interval_us =
        series.interval_us == 0
            ? interval_us
            : series.interval_us + (interval_us - series.interval_us) / 8;
  }
  series.arrivals = std::min(series.arrivals + 1, kMostArrivals);
  series.value = value;
  series.t_us = std::max(t_us, series.t_us);
  series.present = true;
}

std::int64_t Resampler::interval_us(Channel channel) const {
  constexpr int kArrivals = 16;
  const Series& series = series_[static_cast<std::size_t>(channel)];
  const bool even = 3 * series.shortest_us >= 2 * series.interval_us;
  return series.arrivals >= kArrivals && even ? series.interval_us : 0;
}

double Resampler::misplaced() const {
  const Series& u = series_[0];
  const Series& y = series_[1];
  if (!u.cyclic() && !y.cyclic()) return 0;
  const double a = (u.cyclic() ? u : y).phase();
  const double b = (y.cyclic() ? y : u).phase();
  const double low = std::min(a, b);
  const double high = std::max(a, b);
  const double inside = high - low;
  const double nearest = std::min(std::min(low, 1 - low), std::min(high, 1 - high));
  if (nearest >= kComfortable) return 0;
  // The middle of the wider stretch without arrivals.
  const double target = inside > 0.5 ? (low + high) / 2 : high + (1 - inside) / 2;
  return wrapped(target);
}

void Resampler::move(double periods) {
  instant_us_ += std::llround(periods * static_cast<double>(period_us_));
  const double angle = -kTurn * periods;
  for (Series& s : series_) {
    const double cosine = s.cosine * std::cos(angle) - s.sine * std::sin(angle);
    s.sine = s.cosine * std::sin(angle) + s.sine * std::cos(angle);
    s.cosine = cosine;
  }
}

bool Resampler::begin(std::int64_t until_us) {
  const Series& u = series_[0];
  const Series& y = series_[1];
  if (!u.present || !y.present) return false;
  const bool known =
      resumed_ || (u.arrivals >= kArrivalsToStart && y.arrivals >= kArrivalsToStart);
  const std::int64_t newest_us = std::max(u.t_us, y.t_us);
  if (!known && until_us - first_us_ < kPeriodsToStart * period_us_) return false;
  move(misplaced());
  const std::int64_t behind_us = newest_us - instant_us_;
  const std::int64_t periods =
      behind_us < 0 ? -(-behind_us / period_us_) : behind_us / period_us_ + 1;
  instant_us_ += periods * period_us_;
  running_ = true;
  return true;
}

bool Resampler::missed(const Series& series) const {
  if (!series.present || series.interval_us == 0) return false;
  const auto expected =
      static_cast<double>(std::max(series.interval_us, period_us_)) * kLate;
  return static_cast<double>(instant_us_ - series.t_us) > expected;
}

// Where the values have long been void, only the last instants are given.
std::int64_t Resampler::pass_over(std::int64_t until_us) {
  const bool stale =
      std::min(series_[0].t_us, series_[1].t_us) < instant_us_ - stale_after_us_;
  const std::int64_t periods = (until_us - instant_us_) / period_us_;
  if (!stale || periods <= kMostStale) return 0;
  instant_us_ += (periods - kMostStale) * period_us_;
  return periods - kMostStale;
}

bool Resampler::next(std::int64_t until_us, GridSample& out) {
  if (!running_ && !begin(until_us)) return false;
  if (instant_us_ > until_us) return false;
  const Series& u = series_[0];
  const Series& y = series_[1];
  const Series& sp = series_[2];
  out.passed = pass_over(until_us);
  out.t_us = instant_us_;
  out.u = u.value;
  out.y = y.value;
  out.sp = sp.value;
  out.has_sp = sp.present;
  out.held = missed(u) || missed(y);
  out.stale = std::min(u.t_us, y.t_us) < instant_us_ - stale_after_us_;
  instant_us_ += period_us_;
  const double error = misplaced();
  if (error != 0) move(std::clamp(error, -kSteer, kSteer));
  return true;
}

void Resampler::resume(std::int64_t instant_us) {
  any_ = resumed_ = true;
  first_us_ = instant_us_ = instant_us;
}

}  // namespace firmware
