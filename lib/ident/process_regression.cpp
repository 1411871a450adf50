#include "ident/process_regression.hpp"

#include <algorithm>
#include <cmath>

namespace ident {
namespace {

/// x through both poles, started in the steady state of its first sample and counted from
/// there (an offset is estimated anyway, and small numbers keep single precision usable);
/// an integrator runs on x less its mean.
template <class Real>
class PoleFilter {
 public:
  PoleFilter(const ProcessPoles<Real>& poles, std::span<const Real> x)
      : slow_(poles.slow), fast_(poles.fast), origin_(x[0]) {
    if (slow_ < Real(1)) {
      gain_ = (Real(1) - slow_) * (Real(1) - fast_);
      return;
    }
    Real sum = 0;
    for (const Real value : x) {
      sum += value;
    }
    origin_ = sum / static_cast<Real>(x.size());
    // Scaled so that a ramp over the window is of order one.
    gain_ = (Real(1) - fast_) * Real(16) / static_cast<Real>(x.size());
  }
  Real step(Real x) {
    slow_state_ = slow_ * slow_state_ + (x - origin_);
    fast_state_ = fast_ * fast_state_ + slow_state_;
    return gain_ * fast_state_;
  }

 private:
  Real slow_;
  Real fast_;
  Real origin_;
  Real gain_ = 0;
  Real slow_state_ = 0;
  Real fast_state_ = 0;
};

/// p^t without denormal numbers.
template <class Real>
Real decay(Real value, Real pole) {
  value *= pole;
  return value > Real(1e-12) ? value : Real(0);
}

/// What a pole remembered before the window, as a column over its n samples: p^t, and for
/// a slow pole what p^t has that the offset (and the drift, if there is one) have not,
/// scaled to order one. The plain column of a slow pole is all but a sum of those two.
template <class Real>
class StartColumn {
 public:
  StartColumn(Real pole, std::size_t n, bool drift) : pole_(pole) {
    constexpr Real kSlow = Real(0.3);  // left of the start at the end of the window
    const Real last = std::pow(pole, static_cast<Real>(n - 1));
    if (!(pole < Real(1))) {
      factor_ = 0;  // an integrator's start is an offset
    } else if (last > kSlow) {
      // 1 − p^t stays exact near p = 1 where p^t itself does not: u = 1 − p^t.
      value_ = 0;
      growth_ = Real(1) - pole;
      const Real end = Real(1) - last;
      const Real middle = Real(1) - std::sqrt(last);
      slope_ = drift ? end / static_cast<Real>(n - 1) : Real(0);
      constant_ = drift ? Real(0) : end / Real(2);
      const Real height = drift ? middle - end / Real(2) : end / Real(2);
      const Real least = sizeof(Real) < sizeof(double) ? Real(1e-2) : Real(1e-9);
      factor_ = height > least ? Real(1) / height : Real(0);
      slow_ = true;
    }
  }
  /// The column's value at the next sample, from the first on.
  Real next() {
    Real out;
    if (slow_) {
      out = factor_ * (value_ - slope_ * time_ - constant_);
      value_ += growth_ * (Real(1) - value_);
      time_ += Real(1);
    } else {
      out = factor_ * value_;
      value_ = decay(value_, pole_);
    }
    return out;
  }

 private:
  Real pole_;
  Real value_ = 1;
  Real growth_ = 0;
  Real slope_ = 0;
  Real constant_ = 0;
  Real factor_ = 1;
  Real time_ = 0;
  bool slow_ = false;
};

/// A fast pole of 0 is no pole and remembers nothing; no column, like an integrator's.
template <class Real>
Real start_pole(Real fast) {
  return fast > Real(0) ? fast : Real(1);
}

}  // namespace

template <class Real>
ProcessFit<Real> ProcessRegression<Real>::fit(std::span<const Real> x,
                                              std::span<const Real> y,
                                              const ProcessPoles<Real>& poles,
                                              int first_delay, int last_delay,
                                              bool drift) {
  const std::size_t n = y.size();
  const int taps = last_delay - first_delay + 2;
  const int columns = taps + kNuisances;
  for (int i = 0; i < columns; ++i) {
    gram_[i].fill(Real(0));
  }
  cross_.fill(Real(0));
  PoleFilter<Real> filter(poles, x);
  std::array<Real, kDelayTaps> lags{};
  std::array<Real, kColumns> row{};
  StartColumn<Real> slow_start(poles.slow, n, drift);
  StartColumn<Real> fast_start(start_pole(poles.fast), n, drift);
  Real energy = 0;
  const Real step = Real(2) / static_cast<Real>(n);
  for (std::size_t t = 0; t < n; ++t) {
    for (int k = first_delay + taps - 1; k > 0; --k) {
      lags[k] = lags[k - 1];
    }
    lags[0] = filter.step(x[t]);
    for (int k = 0; k < taps; ++k) {
      row[k] = lags[first_delay + k];
    }
    row[taps] = 1;
    row[taps + 1] = drift ? static_cast<Real>(t) * step - Real(1) : Real(0);
    row[taps + 2] = slow_start.next();
    row[taps + 3] = fast_start.next();
    const Real target = y[t];
    energy += target * target;
    for (int i = 0; i < columns; ++i) {
      const Real value = row[i];
      cross_[i] += value * target;
      for (int j = 0; j <= i; ++j) {
        gram_[i][j] += value * row[j];
      }
    }
  }

  // Below this the difference of two sums says nothing.
  const Real floor = energy * (sizeof(Real) < sizeof(double) ? Real(1e-5) : Real(1e-15));
  ProcessFit<Real> best;
  best.error = energy;
  best.delay = first_delay;
  best.drifts = drift;
  constexpr int kUnknowns = 2 + kNuisances;
  normal_.resize(kUnknowns, kUnknowns);
  rhs_.resize(kUnknowns);
  for (int tap = 0; tap + 1 < taps; ++tap) {
    const std::array<int, kUnknowns> index{tap,      tap + 1,  taps,
                                           taps + 1, taps + 2, taps + 3};
    for (int i = 0; i < kUnknowns; ++i) {
      rhs_(i) = cross_[index[i]];
      for (int j = 0; j <= i; ++j) {
        normal_(i, j) = normal_(j, i) = gram_[index[i]][index[j]];
      }
    }
    nnls_.solve(normal_, rhs_, UnknownSet{3}, solution_);
    // At the optimum zᵀQz = cᵀz, so the error is what c does not explain.
    const Real error = energy - rhs_.dot(solution_);
    if (error < best.error) {
      best.error = std::max(error, floor);
      best.delay = first_delay + tap;
      best.gain_a = solution_(0);
      best.gain_b = solution_(1);
      best.offset = solution_(2);
      best.drift = solution_(3);
      best.start_slow = solution_(4);
      best.start_fast = solution_(5);
    }
  }
  return best;
}

template <class Real>
ProcessFit<Real> ProcessRegression<Real>::screen(std::span<const Real> x,
                                                 std::span<const Real> y,
                                                 const ProcessPoles<Real>& poles) {
  const std::size_t n = y.size();
  PoleFilter<Real> filter(poles, x);
  // Ring of the last outputs, doubled so that a run of taps is contiguous.
  std::array<Real, 2 * kDelayTaps> ring{};
  std::array<Real, kDelayTaps> with_y{};
  std::array<Real, kDelayTaps> with_start{};
  const bool integrating = !(poles.slow < Real(1));
  const Real step = Real(1) / static_cast<Real>(n);
  Real own = 0;         // Σ z(t)²
  Real own_lagged = 0;  // Σ z(t)·z(t−1)
  Real sum = 0;
  Real y_sum = 0;
  Real start_sum = 0;
  Real start_own = 0;
  Real start_y = 0;
  Real energy = 0;
  Real start = integrating ? Real(0) : Real(1);
  Real previous = 0;
  std::size_t head = 0;
  for (std::size_t t = 0; t < n; ++t) {
    head = head == 0 ? kDelayTaps - 1 : head - 1;
    const Real z = filter.step(x[t]);
    ring[head] = ring[head + kDelayTaps] = z;
    const Real target = y[t];
    const Real* taps = &ring[head];
    for (int k = 0; k < kDelayTaps; ++k) {
      with_y[k] += taps[k] * target;
      with_start[k] += taps[k] * start;
    }
    own += z * z;
    own_lagged += z * previous;
    previous = z;
    sum += z;
    y_sum += target;
    energy += target * target;
    start_sum += start;
    start_own += start * start;
    start_y += start * target;
    start = integrating ? start + step : decay(start, poles.slow);
  }
  // Everything against the constant, then against what is left of the start.
  const Real y_mean = y_sum / static_cast<Real>(n);
  const Real start_mean = start_sum / static_cast<Real>(n);
  const Real start_left = start_own - start_sum * start_mean;
  const Real y_share = start_left > Real(1e-6) * start_own && start_own > Real(0)
                           ? (start_y - start_sum * y_mean) / start_left
                           : Real(0);
  const Real inverse = y_share != Real(0) ? Real(1) / start_left : Real(0);
  energy -= y_sum * y_mean + y_share * y_share * start_left;
  ProcessFit<Real> best;
  best.error = energy;
  const Real* newest = &ring[head];  // newest[k] is z(n − 1 − k)
  const Real count = static_cast<Real>(n);
  for (int k = 0; k + 1 < kDelayTaps; ++k) {
    // One lag on, a zero from before the window comes in and the newest drops out.
    const Real next_own = own - newest[k] * newest[k];
    const Real next_sum = sum - newest[k];
    const Real da = with_start[k] - sum * start_mean;
    const Real db = with_start[k + 1] - next_sum * start_mean;
    const Real ca = with_y[k] - sum * y_mean - y_share * da;
    const Real cb = with_y[k + 1] - next_sum * y_mean - y_share * db;
    const Real qa = own - sum * sum / count - da * da * inverse;
    const Real qb = next_own - next_sum * next_sum / count - db * db * inverse;
    const Real qab = own_lagged - sum * next_sum / count - da * db * inverse;
    const Real scale = own;
    own_lagged -= newest[k] * newest[k + 1];
    own = next_own;
    sum = next_sum;
    const Real determinant = qa * qb - qab * qab;
    if (!(qa > Real(1e-6) * scale)) {
      continue;
    }
    Real a = 0;
    Real b = 0;
    if (determinant > Real(1e-6) * qa * qb) {
      a = (qb * ca - qab * cb) / determinant;
      b = (qa * cb - qab * ca) / determinant;
    }
    if (!(a > Real(0) && b > Real(0))) {
      a = std::max(ca, Real(0)) / qa;
      b = 0;
    }
    const Real error = energy - a * ca - b * cb;
    if (error < best.error) {
      best.error = error;
      best.delay = k;
      best.gain_a = a;
      best.gain_b = b;
    }
  }
  return best;
}

template <class Real>
void ProcessRegression<Real>::simulate(std::span<const Real> x,
                                       const ProcessPoles<Real>& poles,
                                       const ProcessFit<Real>& fit,
                                       std::span<Real> y) const {
  const std::size_t n = y.size();
  PoleFilter<Real> filter(poles, x);
  std::array<Real, kDelayTaps + 1> lags{};
  StartColumn<Real> slow_start(poles.slow, n, fit.drifts);
  StartColumn<Real> fast_start(start_pole(poles.fast), n, fit.drifts);
  const Real step = Real(2) / static_cast<Real>(n);
  for (std::size_t t = 0; t < n; ++t) {
    for (int k = fit.delay + 1; k > 0; --k) {
      lags[k] = lags[k - 1];
    }
    lags[0] = filter.step(x[t]);
    y[t] = fit.gain_a * lags[fit.delay] + fit.gain_b * lags[fit.delay + 1] + fit.offset +
           fit.drift * (static_cast<Real>(t) * step - Real(1)) +
           fit.start_slow * slow_start.next() + fit.start_fast * fast_start.next();
  }
}

template class ProcessRegression<float>;
template class ProcessRegression<double>;

}  // namespace ident
