#include "ident/signal/noisy_hold.hpp"

#include <algorithm>
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
template <class Real>
Real noise_of(std::span<const Real> y) {
  constexpr int kTurns = 6;
  constexpr Real kMost = Real(2.5);
  // The mean that is left of white noise: √6 · 0.656.
  constexpr Real kOfWhite = Real(1.607);
  Real mean = std::numeric_limits<Real>::max() / kMost;
  for (int turn = 0; turn < kTurns; ++turn) {
    Real sum = 0;
    std::size_t count = 0;
    for (std::size_t t = 2; t < y.size(); ++t) {
      const Real bend = std::abs(y[t] - Real(2) * y[t - 1] + y[t - 2]);
      if (bend <= kMost * mean) {
        sum += bend;
        ++count;
      }
    }
    mean = count > 0 ? sum / static_cast<Real>(count) : Real(0);
  }
  return mean / kOfWhite;
}

template <class Real>
Real mean_of(std::span<const Real> v) {
  Real sum = 0;
  for (const Real value : v) {
    sum += value - v[0];
  }
  return v[0] + sum / static_cast<Real>(v.size());
}

template <class Real>
class Holds {
 public:
  Holds(std::span<const Real> u, Real y_origin) : u_(u), y_origin_(y_origin) {}

  void take(std::span<const Real> y, std::size_t first) {
    const std::size_t n = y.size();
    const Real level = mean_of(y);
    for (std::size_t t = 0; t < n; ++t) {
      squares_ += (y[t] - level) * (y[t] - level);
      if (t > 0) {
        differences_ += (y[t] - y[t - 1]) * (y[t] - y[t - 1]) / Real(2);
      }
    }
    samples_ += n;
    const Real uncertain = Real(1) / static_cast<Real>(n);
    if (holds_ > 0) {
      const Real side = level_[0] > level ? Real(1) : Real(-1);
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
    const Real from = mean_of(u_.subspan(first, third));
    const Real to = mean_of(u_.subspan(first + n - third, third));
    const Real rate = (to - from) / static_cast<Real>(n - third);
    const Real weight = static_cast<Real>(n);
    const Real here[] = {Real(1), level - y_origin_, rate};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j <= i; ++j) {
        moments_[i][j] += weight * here[i] * here[j];
      }
    }
    ++holds_;
  }

  [[nodiscard]] NoisyHold<Real> found(std::size_t samples) const {
    NoisyHold<Real> out;
    out.holds = holds_;
    out.held = static_cast<Real>(samples_) / static_cast<Real>(samples);
    if (holds_ < kFewestHolds || !(differences_ > Real(0))) {
      return out;
    }
    const Real free = static_cast<Real>(samples_ - holds_);
    const Real variance = differences_ / free;
    out.whiteness = squares_ / free / variance;
    out.wander = wander_ / (of_noise_ * variance);
    const Real tails = static_cast<Real>(holds_ - 1);
    out.tail = tail_ / std::sqrt(tails * variance / Real(kTail));
    out.driven = driven();
    out.sticks = out.held >= Real(kLeastHeld) && out.whiteness <= Real(kWhite) &&
                 out.wander >= Real(kWander) && out.tail <= Real(kMostTail) &&
                 out.driven >= Real(kDriven);
    return out;
  }

 private:
  // Of the rates of u, the share of the variance that the levels explain.
  [[nodiscard]] Real driven() const {
    const auto about_means = [&](int i, int j) {
      return moments_[i][j] - moments_[i][0] * moments_[j][0] / moments_[0][0];
    };
    const Real both = about_means(1, 1) * about_means(2, 2);
    return both > Real(0) ? about_means(2, 1) * about_means(2, 1) / both : Real(0);
  }

  std::span<const Real> u_;
  Real y_origin_;
  std::size_t holds_ = 0;
  std::size_t samples_ = 0;
  Real squares_ = 0;
  Real differences_ = 0;
  Real wander_ = 0;
  Real of_noise_ = 0;
  Real tail_ = 0;
  Real moments_[3][3] = {};  // of 1, level, rate of u
  Real level_[2] = {};       // of the latest hold, of the one before
  Real uncertain_[2] = {};
};

}  // namespace

template <class Real>
NoisyHold<Real> find_noisy_hold(std::span<const Real> u, std::span<const Real> y) {
  if (y.size() < kFewestForHolds) {
    return {};
  }
  const Real reach = Real(kReach) * noise_of(y);
  Holds<Real> holds(u, y[0]);
  std::size_t first = 0;
  Real mean = y[0];
  for (std::size_t t = 1; t <= y.size(); ++t) {
    if (t < y.size() && std::abs(y[t] - mean) <= reach) {
      mean += (y[t] - mean) / static_cast<Real>(t - first + 1);
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

template NoisyHold<float> find_noisy_hold<float>(std::span<const float>,
                                                 std::span<const float>);
template NoisyHold<double> find_noisy_hold<double>(std::span<const double>,
                                                   std::span<const double>);

}  // namespace ident
