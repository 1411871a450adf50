#include "ident/signal/noisy_hold.hpp"

#include <cmath>
#include <limits>

#include "ident/signal/sensor_hold.hpp"

namespace ident {
namespace {

constexpr double kWhite = 1.1;
constexpr double kWander = 9;
constexpr double kMostTail = 3;
constexpr std::size_t kTail = 2;  // samples at the begin of a hold
constexpr double kDriven = 0.5;
constexpr double kReach = 4.5;  // of a reading from the mean of its hold, in noise

// Standard deviation of white noise from second differences, less those that moves of the
// process make: again and again, what exceeds kMost times the mean of the rest.
double noise_of(std::span<const double> y) {
  constexpr int kTurns = 6;
  constexpr double kMost = 2.5;
  // The mean that is left of white noise: √6 · 0.656.
  constexpr double kOfWhite = 1.607;
  double mean = std::numeric_limits<double>::max() / kMost;
  for (int turn = 0; turn < kTurns; ++turn) {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t t = 2; t < y.size(); ++t) {
      const double bend = std::abs(y[t] - 2 * y[t - 1] + y[t - 2]);
      if (bend <= kMost * mean) {
        sum += bend;
        ++count;
      }
    }
    mean = count > 0 ? sum / static_cast<double>(count) : 0.0;
  }
  return mean / kOfWhite;
}

double mean_of(std::span<const double> v) {
  double sum = 0;
  for (const double value : v) {
    sum += value - v[0];
  }
  return v[0] + sum / static_cast<double>(v.size());
}

class Holds {
 public:
  Holds(std::span<const double> u, double y_origin) : u_(u), y_origin_(y_origin) {}

  void take(std::span<const double> y, std::size_t first) {
    const std::size_t n = y.size();
    const double level = mean_of(y);
    for (std::size_t t = 0; t < n; ++t) {
      squares_ += (y[t] - level) * (y[t] - level);
      if (t > 0) {
        differences_ += (y[t] - y[t - 1]) * (y[t] - y[t - 1]) / 2;
      }
    }
    samples_ += n;
    const double uncertain = 1 / static_cast<double>(n);
    if (holds_ > 0) {
      const double side = level_[0] > level ? 1.0 : -1.0;
      tail_ += side * (mean_of(y.first(kTail)) - level);
    }
    if (holds_ > 1) {
      wander_ += (level - level_[1]) * (level - level_[1]);
      of_noise_ += uncertain + uncertain_[1];
    }
    level_[1] = level_[0];
    level_[0] = level;
    uncertain_[1] = uncertain_[0];
    uncertain_[0] = uncertain;
    const std::size_t third = n / 3;
    const double from = mean_of(u_.subspan(first, third));
    const double to = mean_of(u_.subspan(first + n - third, third));
    const double rate = (to - from) / static_cast<double>(n - third);
    const double weight = static_cast<double>(n);
    const double here[] = {1.0, level - y_origin_, rate};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j <= i; ++j) {
        moments_[i][j] += weight * here[i] * here[j];
      }
    }
    ++holds_;
  }

  [[nodiscard]] NoisyHold found(std::size_t samples) const {
    NoisyHold out;
    out.holds = holds_;
    out.held = static_cast<double>(samples_) / static_cast<double>(samples);
    if (holds_ < kFewestHolds || !(differences_ > 0)) {
      return out;
    }
    const double free = static_cast<double>(samples_ - holds_);
    const double variance = differences_ / free;
    out.whiteness = squares_ / free / variance;
    out.wander = wander_ / (of_noise_ * variance);
    const double tails = static_cast<double>(holds_ - 1);
    out.tail = tail_ / std::sqrt(tails * variance / static_cast<double>(kTail));
    out.driven = driven();
    out.sticks = out.held >= kLeastHeld && out.whiteness <= kWhite &&
                 out.wander >= kWander && out.tail <= kMostTail && out.driven >= kDriven;
    return out;
  }

 private:
  // Of the rates of u, the share of the variance that the levels explain.
  [[nodiscard]] double driven() const {
    const auto about_means = [&](int i, int j) {
      return moments_[i][j] - moments_[i][0] * moments_[j][0] / moments_[0][0];
    };
    const double both = about_means(1, 1) * about_means(2, 2);
    return both > 0 ? about_means(2, 1) * about_means(2, 1) / both : 0.0;
  }

  std::span<const double> u_;
  double y_origin_;
  std::size_t holds_ = 0;
  std::size_t samples_ = 0;
  double squares_ = 0;
  double differences_ = 0;
  double wander_ = 0;
  double of_noise_ = 0;
  double tail_ = 0;
  double moments_[3][3] = {};  // of 1, level, rate of u
  double level_[2] = {};       // of the latest hold, of the one before
  double uncertain_[2] = {};
};

}  // namespace

NoisyHold find_noisy_hold(std::span<const double> u, std::span<const double> y) {
  if (y.size() < kFewestForHolds) {
    return {};
  }
  const double reach = kReach * noise_of(y);
  Holds holds(u, y[0]);
  std::size_t first = 0;
  double mean = y[0];
  for (std::size_t t = 1; t <= y.size(); ++t) {
    if (t < y.size() && std::abs(y[t] - mean) <= reach) {
      mean += (y[t] - mean) / static_cast<double>(t - first + 1);
      continue;
    }
    if (t - first >= kShortestHold) {
      holds.take(y.subspan(first, t - first), first);
    }
    first = t;
    mean = t < y.size() ? y[t] : mean;
  }
  return holds.found(y.size());
}

}  // namespace ident
