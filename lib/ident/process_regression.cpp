#include "ident/process_regression.hpp"

#include <algorithm>
#include <cmath>

namespace ident {
namespace {

/// x through both poles, started in the steady state of its first sample.
template <class Real>
class PoleFilter {
 public:
  PoleFilter(const ProcessPoles<Real>& poles, std::span<const Real> x)
      : slow_(poles.slow), fast_(poles.fast), integrating_(!(poles.slow < Real(1))) {
    for (const Real value : x) {
      mean_ += value;
    }
    mean_ /= static_cast<Real>(x.size());
    const Real first = x[0] - mean_;
    if (integrating_) {
      // Scaled so that a ramp over the window is of order one.
      gain_ = (Real(1) - fast_) * Real(16) / static_cast<Real>(x.size());
    } else {
      gain_ = (Real(1) - slow_) * (Real(1) - fast_);
      slow_state_ = first / (Real(1) - slow_);
      fast_state_ = slow_state_ / (Real(1) - fast_);
    }
  }
  Real step(Real x) {
    slow_state_ = slow_ * slow_state_ + (x - mean_);
    fast_state_ = fast_ * fast_state_ + slow_state_;
    return gain_ * fast_state_;
  }
  /// Output that was there before the first sample.
  [[nodiscard]] Real held() const { return gain_ * fast_state_; }

 private:
  Real slow_;
  Real fast_;
  bool integrating_;
  Real mean_ = 0;
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
  lags.fill(filter.held());
  std::array<Real, kColumns> row{};
  Real slow_decay = poles.slow < Real(1) ? Real(1) : Real(0);
  Real fast_decay = poles.fast > Real(0) ? Real(1) : Real(0);
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
    row[taps + 2] = slow_decay;
    row[taps + 3] = fast_decay;
    slow_decay = decay(slow_decay, poles.slow);
    fast_decay = decay(fast_decay, poles.fast);
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
  const Real floor = energy * (sizeof(Real) < sizeof(double) ? Real(1e-5) : Real(1e-8));
  ProcessFit<Real> best;
  best.error = energy;
  best.delay = first_delay;
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
      best = {std::max(error, floor), first_delay + tap, solution_(0), solution_(1),
              solution_(2),             solution_(3),      solution_(4), solution_(5)};
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
  const Real held = filter.held();
  ring.fill(held);
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
  Real previous = held;
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
    // One lag on, what was held before the window comes in and the newest drops out.
    const Real next_own = own + held * held - newest[k] * newest[k];
    const Real next_sum = sum + held - newest[k];
    const Real da = with_start[k] - sum * start_mean;
    const Real db = with_start[k + 1] - next_sum * start_mean;
    const Real ca = with_y[k] - sum * y_mean - y_share * da;
    const Real cb = with_y[k + 1] - next_sum * y_mean - y_share * db;
    const Real qa = own - sum * sum / count - da * da * inverse;
    const Real qb = next_own - next_sum * next_sum / count - db * db * inverse;
    const Real qab = own_lagged - sum * next_sum / count - da * db * inverse;
    const Real scale = own;
    own_lagged += held * held - newest[k] * newest[k + 1];
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
  lags.fill(filter.held());
  Real slow_decay = poles.slow < Real(1) ? Real(1) : Real(0);
  Real fast_decay = poles.fast > Real(0) ? Real(1) : Real(0);
  const Real step = Real(2) / static_cast<Real>(n);
  for (std::size_t t = 0; t < n; ++t) {
    for (int k = fit.delay + 1; k > 0; --k) {
      lags[k] = lags[k - 1];
    }
    lags[0] = filter.step(x[t]);
    y[t] = fit.gain_a * lags[fit.delay] + fit.gain_b * lags[fit.delay + 1] + fit.offset +
           fit.drift * (static_cast<Real>(t) * step - Real(1)) +
           fit.start_slow * slow_decay + fit.start_fast * fast_decay;
    slow_decay = decay(slow_decay, poles.slow);
    fast_decay = decay(fast_decay, poles.fast);
  }
}

template class ProcessRegression<float>;
template class ProcessRegression<double>;

}  // namespace ident
