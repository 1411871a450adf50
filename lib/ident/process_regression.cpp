#include "ident/process_regression.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ident/start_column.hpp"
#include "ident/two_gains.hpp"

namespace ident {
namespace {

// Instructions of a Cortex-M4F: of one sample, with a drift, with a fast pole, of one tap
// at one sample, of the end of the sums and of the solution for each tap; and what a
// piece may take, thousands.
constexpr int kPerSample = 70;
constexpr int kPerDrift = 25;
constexpr int kPerFast = 32;
constexpr int kPerTap = 8;
constexpr int kPerEnd = 700;
constexpr int kPerDelay = 400;
constexpr int kMostOfPiece = 80;

constexpr int kLanes = 8;

template <class Real>
Real sum_of(std::array<Real, kLanes> sum) {
  for (int lane = 0; lane < kLanes / 2; ++lane) {
    sum[lane] += sum[lane + kLanes / 2];
  }
  for (int lane = 0; lane < kLanes / 4; ++lane) {
    sum[lane] += sum[lane + kLanes / 4];
  }
  return sum[0] + sum[1];
}

/// Σ a·b in kLanes independent sums: quick where the processor has vectors, and more
/// exact than one after the other everywhere.
template <class Real>
Real dot(const Real* a, const Real* b, int count) {
  std::array<Real, kLanes> sum{};
  int i = 0;
  for (; i + kLanes <= count; i += kLanes) {
#pragma GCC unroll 8
    for (int lane = 0; lane < kLanes; ++lane) {
      sum[lane] += a[i + lane] * b[i + lane];
    }
  }
  for (int lane = 0; i < count; ++i, ++lane) {
    sum[lane] += a[i] * b[i];
  }
  return sum_of(sum);
}

template <class Real>
Real total(const Real* a, int count) {
  std::array<Real, kLanes> sum{};
  int i = 0;
  for (; i + kLanes <= count; i += kLanes) {
#pragma GCC unroll 8
    for (int lane = 0; lane < kLanes; ++lane) {
      sum[lane] += a[i + lane];
    }
  }
  for (int lane = 0; i < count; ++i, ++lane) {
    sum[lane] += a[i];
  }
  return sum_of(sum);
}

// Σ over the first of these is common to all delays; whole lanes.
constexpr int common_samples(int n, int last) {
  return std::max(n - last, 0) / kLanes * kLanes;
}

}  // namespace

template <class Real>
void ProcessRegression<Real>::start(std::span<const Real> x, std::span<const Real> y,
                                    const ProcessPoles<Real>& poles, int first, int last,
                                    bool drift) {
  x_ = x;
  y_ = y;
  filter_ = PoleFilter<Real>(poles, x);
  first_ = first;
  last_ = last;
  next_ = 0;
  drift_ = drift;
  summed_ = false;
  taps_[last] = {};
  with_y_.fill(Real(0));
  nuisance_ = {};
  nuisance_y_ = {};
  energy_ = 0;
  z_[0] = 0;
}

template <class Real>
int ProcessRegression<Real>::cost_of_sample() const {
  const bool fast = !screens_ && fast_start_.pole() < Real(1);
  return kPerSample + (drift_ ? kPerDrift : 0) + (fast ? kPerFast : 0) +
         kPerTap * (last_ - first_ + 1);
}

template <class Real>
int ProcessRegression<Real>::blocks_at_once() const {
  return std::max(kMostOfPiece * 1000 / (kBlock * cost_of_sample()), 1);
}

// Sums of z over t < n − last are common to all delays: what the last samples add to the
// shorter ones follows in finish_taps, so that nothing is ever taken away.
template <class Real>
template <class Slow, class Fast>
bool ProcessRegression<Real>::accumulate(Slow& slow_start, Fast& fast_start) {
  const int n = static_cast<int>(y_.size());
  const int first = first_;
  const int last = last_;
  const bool drift = drift_;
  const int common = common_samples(n, last);
  const int end = next_ + blocks_at_once() * kBlock;
  const Real step = Real(2) / static_cast<Real>(n);
  PoleFilter<Real> filter = filter_;
  Slow slow = slow_start;
  Fast fast = fast_start;
  TapSums sums = taps_[last];
  const Real* z = &z_[1];
  for (int begin = next_, count = 0;; begin += count) {
    if (begin >= end) {
      filter_ = filter;
      slow_start = slow;
      fast_start = fast;
      taps_[last] = sums;
      next_ = begin;
      return false;
    }
    const bool tail = begin >= common;
    count = std::min(kBlock, (tail ? n : common) - begin);
    const bool has_slow = slow.present();
    const bool has_fast = fast.present();
    for (int i = 0; i < count; ++i) {
      z_[i + 1] = filter.step(x_[begin + i]);
      slow_[i] = has_slow ? slow.next() : Real(0);
      fast_[i] = has_fast ? fast.next() : Real(0);
    }
    const Real* target = &y_[begin];
    energy_ += dot(target, target, count);
    nuisance_y_[0] += total(target, count);
    if (drift) {
      for (int i = 0; i < count; ++i) {
        ramp_[i] = static_cast<Real>(begin + i) * step - Real(1);
      }
      nuisance_y_[1] += dot(ramp_.data(), target, count);
    }
    if (has_slow) {
      nuisance_y_[2] += dot(slow_.data(), target, count);
      nuisance_[2][0] += total(slow_.data(), count);
      nuisance_[2][1] += drift ? dot(slow_.data(), ramp_.data(), count) : Real(0);
      nuisance_[2][2] += dot(slow_.data(), slow_.data(), count);
    }
    if (has_fast) {
      nuisance_y_[3] += dot(fast_.data(), target, count);
      nuisance_[3][0] += total(fast_.data(), count);
      nuisance_[3][1] += drift ? dot(fast_.data(), ramp_.data(), count) : Real(0);
      nuisance_[3][2] += has_slow ? dot(fast_.data(), slow_.data(), count) : Real(0);
      nuisance_[3][3] += dot(fast_.data(), fast_.data(), count);
    }
    if (tail) {
      break;
    }
    sums.own += dot(z, z, count);
    sums.with_next += dot(z, z_.data(), count);
    sums.with[0] += total(z, count);
    sums.with[1] += drift ? dot(z, ramp_.data(), count) : Real(0);
    sums.with[2] += has_slow ? dot(z, slow_.data(), count) : Real(0);
    sums.with[3] += has_fast ? dot(z, fast_.data(), count) : Real(0);
    for (int delay = first; delay <= last; ++delay) {
      with_y_[delay] += dot(z, target + delay, count);
    }
    z_[0] = z[count - 1];
  }
  const Real samples = static_cast<Real>(n);
  nuisance_[0][0] = samples;
  if (drift) {
    // Σ(2t/n − 1) and its square.
    nuisance_[1][0] = Real(-1);
    nuisance_[1][1] = samples / Real(3) + Real(2) / (Real(3) * samples);
  } else {
    ramp_.fill(Real(0));
  }
  taps_[last] = sums;
  finish_taps(slow, fast);
  return true;
}

// The last samples of z, those of the block at hand, added to the taps that reach them;
// then the columns moved to where each tap has them.
template <class Real>
template <class Slow, class Fast>
void ProcessRegression<Real>::finish_taps(const Slow& slow, const Fast& fast) {
  const int n = static_cast<int>(y_.size());
  const int first = first_;
  const int last = last_;
  const int common = common_samples(n, last);
  const Real* z = &z_[1];
  TapSums tap = taps_[last];
  int i = 0;
  for (int delay = last; delay >= first; --delay) {
    const int reach = n - delay - common;
    for (; i < reach; ++i) {
      tap.own += z[i] * z[i];
      tap.with_next += z[i] * z_[i];
      tap.with[0] += z[i];
      tap.with[1] += z[i] * ramp_[i];
      tap.with[2] += z[i] * slow_[i];
      tap.with[3] += z[i] * fast_[i];
    }
    taps_[delay] = tap;
    if (reach > 0) {
      with_y_[delay] += dot(z, &y_[common] + delay, reach);
    }
  }
  const Real step = Real(2) / static_cast<Real>(n);
  PolePower<Real> of_slow(slow.pole());
  PolePower<Real> of_fast(fast.pole());
  for (int delay = 0; delay <= last; ++delay) {
    if (delay >= first) {
      Nuisances& with = taps_[delay].with;
      const ColumnShift<Real> slow_shift = slow.shift(delay, of_slow);
      const ColumnShift<Real> fast_shift = fast.shift(delay, of_fast);
      const Real ramp = with[1] + with[0];
      with[2] = slow_shift.share * with[2] + slow_shift.constant * with[0] +
                slow_shift.slope * ramp;
      with[3] = fast_shift.share * with[3] + fast_shift.constant * with[0] +
                fast_shift.slope * ramp;
      with[1] += static_cast<Real>(delay) * step * with[0];
    }
    of_slow.next();
    of_fast.next();
  }
}

template <class Real>
void ProcessRegression<Real>::start_fit(std::span<const Real> x, std::span<const Real> y,
                                        const ProcessPoles<Real>& poles, int first_delay,
                                        int last_delay, bool drift) {
  slow_start_ = StartColumn<Real>(poles.slow, y.size(), drift);
  fast_start_ = StartColumn<Real>(start_pole(poles.fast), y.size(), drift);
  screens_ = false;
  start(x, y, poles, first_delay, last_delay + 1, drift);
}

template <class Real>
void ProcessRegression<Real>::start_screen(std::span<const Real> x,
                                           std::span<const Real> y,
                                           const ProcessPoles<Real>& poles) {
  plain_start_ = PlainStart<Real>(poles.slow, y.size());
  screens_ = true;
  start(x, y, poles, 0, kDelayTaps - 1, false);
}

template <class Real>
bool ProcessRegression<Real>::step() {
  if (!summed_) {
    NoStart<Real> none;
    summed_ =
        screens_ ? accumulate(plain_start_, none) : accumulate(slow_start_, fast_start_);
    return false;
  }
  if (screens_) {
    solve_screen();
  } else {
    solve_fit();
  }
  return true;
}

template <class Real>
int ProcessRegression<Real>::cost_of_step() const {
  const int taps = last_ - first_ + 1;
  if (summed_) {
    return taps * kPerDelay / 1000 + 1;
  }
  const int left = static_cast<int>(y_.size()) - next_;
  const int samples = std::min(blocks_at_once() * kBlock, left);
  const int end = samples == left ? taps * kPerEnd : 0;
  return (samples * cost_of_sample() + end) / 1000 + 1;
}

template <class Real>
ProcessFit<Real> ProcessRegression<Real>::fit(std::span<const Real> x,
                                              std::span<const Real> y,
                                              const ProcessPoles<Real>& poles,
                                              int first_delay, int last_delay,
                                              bool drift) {
  start_fit(x, y, poles, first_delay, last_delay, drift);
  while (!step()) {
  }
  return best_;
}

template <class Real>
ProcessFit<Real> ProcessRegression<Real>::screen(std::span<const Real> x,
                                                 std::span<const Real> y,
                                                 const ProcessPoles<Real>& poles) {
  start_screen(x, y, poles);
  while (!step()) {
  }
  return best_;
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

template <class Real>
void ProcessRegression<Real>::simulate(std::span<const Real> x,
                                       const ProcessPoles<Real>& poles,
                                       const ProcessFit<Real>& fit,
                                       std::span<Real> y) const {
  ProcessSimulation<Real> simulation;
  simulation.start(x, poles, fit, y);
  simulation.step(y.size());
}

template class ProcessRegression<float>;
template class ProcessRegression<double>;

}  // namespace ident
