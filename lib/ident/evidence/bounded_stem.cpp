#include "ident/evidence/bounded_stem.hpp"

#include <algorithm>

#include "ident/base/elementary.hpp"

namespace ident {
namespace {

constexpr std::size_t kRows = 16;
constexpr std::size_t kFewestRows = 100;
// Over the mean speed of u from one turning point to the next: from one of these to the
// next faster one.
constexpr int kSpeeds = 10;
constexpr double kSlowest = 0.25;
constexpr double kFaster = 1.4142;
// Ends, as shares of the range of u, from either side.
constexpr int kEnds = 6;
constexpr double kEndsApart = 0.1;
constexpr int kMostOfBoth = 8;  // of such shares

}  // namespace

template <class Real>
void BoundedStem<Real>::start(const EvidenceWindow<Real>& window) {
  *this = {};
  window_ = window;
  thinning_ = evidence_thinning(window);
  count_ = window.u.size() / thinning_;
  sums().start(lag_bins_for(count_, kCoarseLagBins));
  next_ = sums().reach();
  const bool known = window.period > Real(0) && count_ >= next_ + kFewestRows;
  stage_ = known ? Stage::kThin : Stage::kDone;
}

template <class Real>
void BoundedStem<Real>::thin() {
  y_ = window_.y.first(count_);
  if (thinning_ > 1) {
    const std::span<Real> thinned = window_.scratch.last(count_);
    thin_out(window_.y, thinning_, thinned);
    y_ = thinned;
  }
  stage_ = Stage::kOutput;
}

// The next stem; false: there is none.
template <class Real>
bool BoundedStem<Real>::lay() {
  const auto [low, high] = std::minmax_element(window_.u.begin(), window_.u.end());
  low_ = *low;
  high_ = *high;
  speed_ = 0;
  if (tried_ > 0 && tried_ <= kSpeeds) {
    speed_ = Real(2) * Real(kSlowest) * window_.swing / window_.period;
    for (int k = 1; k < tried_; ++k) {
      speed_ *= Real(kFaster);
    }
  } else if (tried_ > kSpeeds) {
    const int pair = tried_ - kSpeeds;  // 0 would be no end at all
    const int below = pair % kEnds;
    const int above = pair / kEnds;
    if (above >= kEnds) {
      return false;
    }
    const Real share = Real(kEndsApart) * (*high - *low);
    low_ += static_cast<Real>(below) * share;
    high_ -= static_cast<Real>(std::min(above, kMostOfBoth - below)) * share;
  }
  const std::span<Real> x = window_.scratch.first(count_);
  Real stem = std::clamp(window_.u[0], low_, high_);
  for (std::size_t t = 0; t < count_; ++t) {
    Real sum = 0;
    for (std::size_t k = 0; k < thinning_; ++k) {
      stem = moved(stem, window_.u[t * thinning_ + k]);
      sum += stem;
    }
    x[t] = sum / static_cast<Real>(thinning_);
  }
  return true;
}

template <class Real>
Real BoundedStem<Real>::moved(Real x, Real u) const {
  const Real wanted = std::clamp(u, low_, high_);
  return speed_ > Real(0) ? std::clamp(wanted, x - speed_, x + speed_) : wanted;
}

template <class Real>
void BoundedStem<Real>::take_error() {
  const Real log_error = elementary::log(sums().error());
  if (tried_ == 0) {
    log_follows_ = log_error;
  }
  const Real rows = static_cast<Real>(count_ - sums().reach());
  const Real nats = rows / Real(2) * (log_follows_ - log_error) - elementary::log(rows);
  if (nats > nats_) {
    nats_ = nats;
    bound_ = tried_ > kSpeeds ? Bound::kTravel : Bound::kSpeed;
  }
  ++tried_;
  stage_ = Stage::kLay;
}

template <class Real>
int BoundedStem<Real>::piece() {
  switch (stage_) {
    case Stage::kThin:
      thin();
      break;
    case Stage::kLay:
      stage_ = lay() ? Stage::kInput : Stage::kDone;
      sums().begin_input();
      next_ = sums().reach();
      break;
    case Stage::kOutput:
    case Stage::kInput: {
      const std::size_t end = std::min(next_ + kRows, count_);
      if (stage_ == Stage::kOutput) {
        sums().add_output(y_, next_, end);
      } else {
        sums().add_input(y_, window_.scratch.first(count_), next_, end);
      }
      next_ = end;
      if (next_ == count_ && stage_ == Stage::kInput) {
        take_error();
      } else if (next_ == count_) {
        stage_ = Stage::kLay;
      }
      break;
    }
    case Stage::kDone:
      break;
  }
  return kUnit;
}

template <class Real>
bool BoundedStem<Real>::step(int budget) {
  for (int left = budget * kUnit; left > 0 && stage_ != Stage::kDone;) {
    left -= piece();
  }
  return stage_ == Stage::kDone;
}

template class BoundedStem<float>;
template class BoundedStem<double>;

}  // namespace ident
