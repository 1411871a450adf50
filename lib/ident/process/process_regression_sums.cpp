// The sums over the samples behind a process regression.
#include <algorithm>
#include <cstddef>
#include <utility>

#include "ident/base/pair.hpp"
#include "ident/process/process_regression.hpp"
#include "ident/process/start_column.hpp"

namespace ident {
namespace {

// Instructions of a Cortex-M4F: of one sample of z and its sums, with a drift, with a
// fast pole, of one tap at one sample; of the columns' own sums at one sample; of the end
// of the sums and of the solution for each tap; and what a piece may take, thousands.
constexpr int kPerSample = 45;
constexpr int kPerDrift = 5;
constexpr int kPerFast = 15;
constexpr int kPerTap = 4;
constexpr int kPerOwn = 30;
constexpr int kPerOwnFast = 32;
constexpr int kPerEnd = 700;
constexpr int kPerDelay = 400;
constexpr int kMostOfPiece = 80;

constexpr int kTogether = 4;  // taps whose sums are made in one loop, samples of a turn

/// Adds Σ z(i)·y(i + k) to sums[k] for each tap k; `count` is a multiple of kTogether.
template <class Real, std::size_t... kTap>
void correlate(const Real* z, const Real* y, int count, Real* sums,
               std::index_sequence<kTap...> /*taps*/) {
  std::array<Pair<Real>, sizeof...(kTap)> sum{};
  for (int i = 0; i < count; i += kTogether) {
    const Pair<Real> first = pair_at(z + i);
    const Pair<Real> second = pair_at(z + i + 2);
    ((sum[kTap] += first * pair_at(y + i + kTap)), ...);
    ((sum[kTap] += second * pair_at(y + i + 2 + kTap)), ...);
  }
  ((sums[kTap] += sum_of<Real>(sum[kTap])), ...);
}

/// Σ a·b in four independent sums.
template <class Real>
Real dot(const Real* a, const Real* b, int count) {
  Pair<Real> first{};
  Pair<Real> second{};
  int i = 0;
  for (; i + kTogether <= count; i += kTogether) {
    first += pair_at(a + i) * pair_at(b + i);
    second += pair_at(a + i + 2) * pair_at(b + i + 2);
  }
  for (; i < count; ++i) {
    first += Pair<Real>{a[i] * b[i], Real(0)};
  }
  return sum_of<Real>(first + second);
}

// Σ over the first of these is common to all delays; a multiple of kTogether.
constexpr int common_samples(int n, int last) {
  return std::max(n - last, 0) / kTogether * kTogether;
}

}  // namespace

template <class Real>
int ProcessRegression<Real>::cost_of_sample() const {
  const bool fast = !screens_ && fast_start_.pole() < Real(1);
  if (stage_ == Stage::kOwn) {
    return kPerOwn + (fast ? kPerOwnFast : 0);
  }
  return kPerSample + (drift_ ? kPerDrift : 0) + (fast ? kPerFast : 0) +
         kPerTap * (last_ - first_ + 1);
}

template <class Real>
int ProcessRegression<Real>::blocks_at_once() const {
  return std::max(kMostOfPiece * 1000 / (kBlock * cost_of_sample()), 1);
}

// Sums of y and of the columns beside z, over the whole window.
template <class Real>
template <class Slow, class Fast>
void ProcessRegression<Real>::add_own(Slow& slow_start, Fast& fast_start) {
  const int n = static_cast<int>(y_.size());
  const int end = std::min(next_ + blocks_at_once() * kBlock, n);
  const Real step = Real(2) / static_cast<Real>(n);
  const bool drift = drift_;
  Slow slow = slow_start;
  Fast fast = fast_start;
  for (; next_ < end; next_ += kBlock) {
    const int count = std::min(kBlock, n - next_);
    const Real* y = &y_[next_];
    const bool has_slow = slow.present();
    const bool has_fast = fast.present();
    Nuisances of_y{};
    Nuisances of_slow{};
    Nuisances of_fast{};
    Real energy = 0;
    Real ramp = 0;
    for (int i = 0; i < count; ++i) {
      const Real slow_value = has_slow ? slow.next() : Real(0);
      energy += y[i] * y[i];
      of_y[0] += y[i];
      of_y[2] += y[i] * slow_value;
      of_slow[0] += slow_value;
      of_slow[2] += slow_value * slow_value;
      if (drift) {
        ramp = static_cast<Real>(next_ + i) * step - Real(1);
        of_y[1] += y[i] * ramp;
        of_slow[1] += slow_value * ramp;
      }
      if (has_fast) {
        const Real fast_value = fast.next();
        of_y[3] += y[i] * fast_value;
        of_fast[0] += fast_value;
        of_fast[1] += fast_value * ramp;
        of_fast[2] += fast_value * slow_value;
        of_fast[3] += fast_value * fast_value;
      }
    }
    for (int k = 0; k < kNuisances; ++k) {
      nuisance_[2][k] += of_slow[k];
      nuisance_[3][k] += of_fast[k];
    }
    energy_ += energy;
    for (int k = 0; k < kNuisances; ++k) {
      nuisance_y_[k] += of_y[k];
    }
  }
  slow_start = slow;
  fast_start = fast;
  if (next_ < n) {
    return;
  }
  slow_start.restart();
  fast_start.restart();
  end_own();
}

template <class Real>
void ProcessRegression<Real>::end_own() {
  const Real samples = static_cast<Real>(y_.size());
  nuisance_[0][0] = samples;
  if (drift_) {
    // Σ(2t/n − 1) and its square.
    nuisance_[1][0] = Real(-1);
    nuisance_[1][1] = samples / Real(3) + Real(2) / (Real(3) * samples);
  }
  own_.known = keeps_;
  if (screens_) {
    remember_screen();
  }
  next_ = 0;
  stage_ = Stage::kTaps;
}

// What solve_screen needs of the sums without x, from an earlier screen of the same y.
template <class Real>
void ProcessRegression<Real>::recall_screen(int index) {
  const Nuisances& sums = screened_.sums[index];
  nuisance_[2][0] = sums[0];
  nuisance_[2][2] = sums[1];
  nuisance_y_[2] = sums[2];
  nuisance_y_[0] = screened_.y_sum;
  energy_ = screened_.energy;
  stage_ = Stage::kTaps;
}

template <class Real>
void ProcessRegression<Real>::remember_screen() {
  if (screened_.y == nullptr || screened_.count == kScreened) {
    return;
  }
  screened_.pole[screened_.count] = pole_of_screen();
  screened_.sums[screened_.count] = {nuisance_[2][0], nuisance_[2][2], nuisance_y_[2]};
  screened_.y_sum = nuisance_y_[0];
  screened_.energy = energy_;
  ++screened_.count;
}

// Sums of z over t < n − last are common to all delays: what the last samples add to the
// shorter ones follows in finish_taps, so that nothing is ever taken away.
template <class Real>
template <class Slow, class Fast>
void ProcessRegression<Real>::add_taps(Slow& slow, Fast& fast) {
  const int n = static_cast<int>(y_.size());
  const int common = common_samples(n, last_);
  const int end = std::min(next_ + blocks_at_once() * kBlock, common);
  for (; next_ < end; next_ += kBlock) {
    add_common(std::min(kBlock, common - next_), slow, fast);
  }
  if (next_ >= common) {
    for (int i = 0; common + i < n; ++i) {
      z_[i + 1] = filter_.step(x_[common + i]);
      slow_[i] = slow.present() ? slow.next() : Real(0);
      fast_[i] = fast.present() ? fast.next() : Real(0);
    }
    finish_taps(slow, fast);
    if (filter_.moved_before()) {
      add_before(slow, fast);
    }
    stage_ = Stage::kSolve;
  }
}

template <class Real>
template <class Slow, class Fast>
void ProcessRegression<Real>::add_common(int count, Slow& slow_start, Fast& fast_start) {
  PoleFilter<Real> filter = filter_;  // copies stay in registers
  Slow slow = slow_start;
  Fast fast = fast_start;
  const Real* x = &x_[next_];
  const Real step = Real(2) / static_cast<Real>(y_.size());
  TapSums sums;
  Real* z = &z_[1];
  Real before = z_[0];
  const bool has_slow = slow.present();
  const bool has_fast = fast.present();
  const bool drift = drift_;
  Real place = static_cast<Real>(next_);
  for (int i = 0; i < count; ++i, place += Real(1)) {
    const Real value = filter.step(x[i]);
    z[i] = value;
    sums.own += value * value;
    sums.with_next += value * before;
    sums.with[0] += value;
    if (drift) {
      sums.with[1] += value * (place * step - Real(1));
    }
    if (has_slow) {
      sums.with[2] += value * slow.next();
    }
    if (has_fast) {
      sums.with[3] += value * fast.next();
    }
    before = value;
  }
  filter_ = filter;
  slow_start = slow;
  fast_start = fast;
  TapSums& tap = taps_[last_];
  tap.own += sums.own;
  tap.with_next += sums.with_next;
  for (int k = 0; k < kNuisances; ++k) {
    tap.with[k] += sums.with[k];
  }
  const Real* y = &y_[next_];
  int delay = first_;
  for (; delay + kTogether <= last_ + 1; delay += kTogether) {
    correlate(z, y + delay, count, &with_y_[delay],
              std::make_index_sequence<kTogether>());
  }
  for (; delay <= last_; ++delay) {
    with_y_[delay] += dot(z, y + delay, count);
  }
  z_[0] = before;
}

// The last samples of z, added to the taps that reach them;
// then the columns moved to where each tap has them.
template <class Real>
template <class Slow, class Fast>
void ProcessRegression<Real>::finish_taps(const Slow& slow, const Fast& fast) {
  const int n = static_cast<int>(y_.size());
  const int first = first_;
  const int last = last_;
  const int common = common_samples(n, last);
  const Real* z = &z_[1];
  const Real step = Real(2) / static_cast<Real>(n);
  TapSums tap = taps_[last];
  int i = 0;
  for (int delay = last; delay >= first; --delay) {
    const int reach = n - delay - common;
    for (; i < reach; ++i) {
      tap.own += z[i] * z[i];
      tap.with_next += z[i] * z_[i];
      tap.with[0] += z[i];
      tap.with[1] +=
          drift_ ? z[i] * (static_cast<Real>(common + i) * step - Real(1)) : Real(0);
      tap.with[2] += z[i] * slow_[i];
      tap.with[3] += z[i] * fast_[i];
    }
    taps_[delay] = tap;
    if (reach > 0) {
      with_y_[delay] += dot(z, &y_[common] + delay, reach);
    }
  }
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

// What came before the window, added to the taps that reach it.
template <class Real>
template <class Slow, class Fast>
void ProcessRegression<Real>::add_before(Slow slow, Fast fast) {
  slow.restart();
  fast.restart();
  const int n = static_cast<int>(y_.size());
  for (int t = 0; t < std::min(last_, n); ++t) {
    slow_[t] = slow.present() ? slow.next() : Real(0);
    fast_[t] = fast.present() ? fast.next() : Real(0);
  }
  const Real step = Real(2) / static_cast<Real>(n);
  Real own = 0;
  Real with_next = 0;
  Real sum = 0;
  for (int delay = 1; delay <= last_; ++delay) {
    const Real z = before_[delay - 1];
    own += z * z;
    with_next += z * before_[delay];
    sum += z;
    if (delay < first_) {
      continue;
    }
    TapSums& tap = taps_[delay];
    tap.own += own;
    tap.with_next += with_next;
    tap.with[0] += sum;
    for (int t = 0; t < std::min(delay, n); ++t) {
      const Real value = before_[delay - 1 - t];
      with_y_[delay] += value * y_[t];
      tap.with[1] += drift_ ? value * (static_cast<Real>(t) * step - Real(1)) : Real(0);
      tap.with[2] += value * slow_[t];
      tap.with[3] += value * fast_[t];
    }
  }
}

template <class Real>
template <class Slow, class Fast>
void ProcessRegression<Real>::add(Slow& slow, Fast& fast) {
  if (stage_ == Stage::kOwn) {
    add_own(slow, fast);
  } else {
    add_taps(slow, fast);
  }
}

template <class Real>
bool ProcessRegression<Real>::step() {
  if (stage_ != Stage::kSolve) {
    if constexpr (kLeastSizes) {
      add(slow_start_, fast_start_);
    } else if (screens_) {
      NoStart<Real> none;
      add(plain_start_, none);
    } else {
      add(slow_start_, fast_start_);
    }
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
  if (stage_ == Stage::kSolve) {
    return taps * kPerDelay / 1000 + 1;
  }
  const int left = static_cast<int>(y_.size()) - next_;
  const int samples = std::min(blocks_at_once() * kBlock, left);
  const int end = samples == left ? taps * kPerEnd : 0;
  return (samples * cost_of_sample() + end) / 1000 + 1;
}

#define STICKBAND_INSTANTIATE(Real)                          \
  template void ProcessRegression<Real>::recall_screen(int); \
  template bool ProcessRegression<Real>::step();             \
  template int ProcessRegression<Real>::cost_of_step() const;
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)

}  // namespace ident
