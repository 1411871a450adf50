#include "ident/process/process_regression.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ident/base/two_gains.hpp"
#include "ident/process/start_column.hpp"

namespace ident {

template <class Real>
void ProcessRegression<Real>::start(std::span<const Real> x, std::span<const Real> y,
                                    const ProcessPoles<Real>& poles, int first, int last,
                                    bool drift, bool keeps_output) {
  x_ = x;
  y_ = y;
  filter_ = PoleFilter<Real>(poles, x);
  first_ = first;
  last_ = last;
  next_ = 0;
  taps_[last] = {};
  with_y_.fill(Real(0));
  before_ = filter_.before();
  z_[0] = before_[0];
  drift_ = drift;
  stage_ = Stage::kTaps;
  keeps_ = keeps_output;
  OwnSums own{y.data(), y.size(), poles, drift, true};
  if (!keeps_ || !(own == own_)) {
    own.known = false;
    own_ = own;
    nuisance_ = {};
    nuisance_y_ = {};
    energy_ = 0;
    stage_ = Stage::kOwn;
  }
}

template <class Real>
void ProcessRegression<Real>::start_fit(std::span<const Real> x, std::span<const Real> y,
                                        const ProcessPoles<Real>& poles, int first_delay,
                                        int last_delay, bool drift, bool keeps_output) {
  slow_start_ = StartColumn<Real>(poles.slow, y.size(), drift);
  fast_start_ = StartColumn<Real>(start_pole(poles.fast), y.size(), drift);
  screens_ = false;
  start(x, y, poles, first_delay, last_delay + 1, drift, keeps_output);
}

template <class Real>
void ProcessRegression<Real>::start_screen(std::span<const Real> x,
                                           std::span<const Real> y,
                                           const ProcessPoles<Real>& poles,
                                           bool keeps_output) {
  if constexpr (kLeastSizes) {
    slow_start_ = StartColumn<Real>::plain(poles.slow, y.size());
    fast_start_ = StartColumn<Real>::none();
  } else {
    plain_start_ = PlainStart<Real>(poles.slow, y.size());
  }
  screens_ = true;
  start(x, y, poles, 0, kDelayTaps - 1, false, false);
  if (!keeps_output) {
    screened_ = {};
    return;
  }
  if (screened_.y != y.data() || screened_.samples != y.size()) {
    screened_ = {};
    screened_.y = y.data();
    screened_.samples = y.size();
  }
  for (int i = 0; i < screened_.count; ++i) {
    if (screened_.pole[i] == poles.slow) {
      recall_screen(i);
      return;
    }
  }
}

template <class Real>
void ProcessRegression<Real>::solve_fit() {
  const int first_delay = first_;
  const int last_delay = last_ - 1;
  constexpr Real kEpsilon = std::numeric_limits<Real>::epsilon();
  const Elimination<Real, kNuisances> elimination(nuisance_);
  const Nuisances of_y = elimination.shares(nuisance_y_);
  const Nuisances plain = elimination.weights(of_y);
  const Real energy_left = energy_ - inner(of_y, of_y);
  const auto remainder = [&](int delay, const Nuisances& shares) {
    const TapSums& tap = taps_[delay];
    Remainder<Real> out;
    out.own = tap.own - inner(shares, shares);
    if (!(out.own > Real(16) * kEpsilon * tap.own)) {
      out.own = 0;
    }
    out.with_y = with_y_[delay] - inner(shares, of_y);
    Real size = std::abs(with_y_[delay]);
    for (int i = 0; i < kNuisances; ++i) {
      size += std::abs(tap.with[i] * plain[i]);
    }
    out.noise = Real(64) * kEpsilon * size;
    return out;
  };

  // Below this the difference of two sums says nothing.
  const Real floor = energy_ * (sizeof(Real) < sizeof(double) ? Real(1e-5) : Real(1e-15));
  ProcessFit<Real>& best = best_;
  best = {};
  best.error = energy_;
  best.delay = first_delay;
  best.drifts = drift_;
  Nuisances best_shares = of_y;
  Nuisances shares_b = elimination.shares(taps_[first_delay].with);
  Remainder<Real> b = remainder(first_delay, shares_b);
  for (int delay = first_delay; delay <= last_delay; ++delay) {
    const Nuisances shares_a = shares_b;
    const Remainder<Real> a = b;
    shares_b = elimination.shares(taps_[delay + 1].with);
    b = remainder(delay + 1, shares_b);
    const Real mixed = taps_[delay].with_next - inner(shares_a, shares_b);
    const Gains<Real> gains = non_negative_gains(a, b, mixed);
    // At the optimum zᵀQz = cᵀz, so the error is what c does not explain.
    const Real error = energy_left - gains.a * a.with_y - gains.b * b.with_y;
    if (error < best.error) {
      best.error = std::max(error, floor);
      best.delay = delay;
      best.gain_a = gains.a;
      best.gain_b = gains.b;
      for (int i = 0; i < kNuisances; ++i) {
        best_shares[i] = of_y[i] - gains.a * shares_a[i] - gains.b * shares_b[i];
      }
    }
  }
  const Nuisances weights = elimination.weights(best_shares);
  best.offset = weights[0];
  best.drift = weights[1];
  best.start_slow = weights[2];
  best.start_fast = weights[3];
}

template <class Real>
void ProcessRegression<Real>::solve_screen() {
  // Everything against the constant, then against what is left of the start.
  const Real count = static_cast<Real>(y_.size());
  const Real y_mean = nuisance_y_[0] / count;
  const Real start_sum = nuisance_[2][0];
  const Real start_mean = start_sum / count;
  const Real start_own = nuisance_[2][2];
  const Real start_left = start_own - start_sum * start_mean;
  const Real y_share = start_left > Real(1e-6) * start_own && start_own > Real(0)
                           ? (nuisance_y_[2] - start_sum * y_mean) / start_left
                           : Real(0);
  const Real inverse = y_share != Real(0) ? Real(1) / start_left : Real(0);
  const Real energy =
      energy_ - (nuisance_y_[0] * y_mean + y_share * y_share * start_left);
  ProcessFit<Real>& best = best_;
  best = {};
  best.error = energy;
  for (int k = 0; k + 1 < kDelayTaps; ++k) {
    const TapSums& first = taps_[k];
    const TapSums& second = taps_[k + 1];
    const Real sum_a = first.with[0];
    const Real sum_b = second.with[0];
    const Real da = first.with[2] - sum_a * start_mean;
    const Real db = second.with[2] - sum_b * start_mean;
    const Real ca = with_y_[k] - sum_a * y_mean - y_share * da;
    const Real cb = with_y_[k + 1] - sum_b * y_mean - y_share * db;
    const Real qa = first.own - sum_a * sum_a / count - da * da * inverse;
    const Real qb = second.own - sum_b * sum_b / count - db * db * inverse;
    const Real qab = first.with_next - sum_a * sum_b / count - da * db * inverse;
    const Real determinant = qa * qb - qab * qab;
    if (!(qa > Real(1e-6) * first.own)) {
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
}

template class ProcessRegression<float>;
template class ProcessRegression<double>;

}  // namespace ident
