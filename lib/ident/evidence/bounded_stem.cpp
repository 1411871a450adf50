#include "ident/evidence/bounded_stem.hpp"

#include <algorithm>

#include "ident/base/elementary.hpp"

namespace ident {
namespace {

constexpr std::size_t kRows = 16;
// Over the mean speed of u from one turning point to the next: from one of these to the
// next faster one.
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
  begin_sums(kCoarseLagBins);
  const bool known = window.period > Real(0) && count_ >= next_ + kFewestRows;
  stage_ = known ? Stage::kThin : Stage::kDone;
}

template <class Real>
void BoundedStem<Real>::begin_sums(std::span<const LagBin> bins) {
  sums().start(lag_bins_for(count_, bins));
  next_ = sums().reach();
  tried_ = 0;
  stage_ = Stage::kOutput;
}

template <class Real>
void BoundedStem<Real>::bound_by(int stem) {
  const auto [low, high] = std::minmax_element(window_.u.begin(), window_.u.end());
  low_ = *low;
  high_ = *high;
  speed_ = 0;
  if (stem > 0 && stem <= kSpeeds) {
    speed_ = Real(2) * Real(kSlowest) * window_.swing / window_.period;
    for (int k = 1; k < stem; ++k) {
      speed_ *= Real(kFaster);
    }
  } else if (stem > kSpeeds) {
    const int pair = stem - kSpeeds;  // 0 would be no end at all
    const int below = pair % kEnds;
    const int above = std::min(pair / kEnds, kMostOfBoth - below);
    const Real share = Real(kEndsApart) * (*high - *low);
    low_ += static_cast<Real>(below) * share;
    high_ -= static_cast<Real>(above) * share;
  }
}

template <class Real>
Real BoundedStem<Real>::moved(Real x, Real u) const {
  const Real wanted = std::clamp(u, low_, high_);
  return speed_ > Real(0) ? std::clamp(wanted, x - speed_, x + speed_) : wanted;
}

template <class Real>
void BoundedStem<Real>::lay() {
  bound_by(tried_);
  Real position = std::clamp(window_.u[0], low_, high_);
  for (std::size_t t = 0; t < count_; ++t) {
    Real sum = 0;
    for (std::size_t k = 0; k < thinning_; ++k) {
      position = moved(position, window_.u[t * thinning_ + k]);
      sum += position;
    }
    stem()[t] = sum / static_cast<Real>(thinning_);
  }
  sums().begin_input();
  next_ = sums().reach();
  stage_ = Stage::kInput;
}

template <class Real>
void BoundedStem<Real>::take_error() {
  const Real log_error = elementary::log(sums().error());
  if (tried_ == 0) {
    log_follows_ = log_error;
  }
  const Real rows = static_cast<Real>(count_ - sums().reach());
  const Real nats = rows / Real(2) * (log_follows_ - log_error) - elementary::log(rows);
  if (!confirming_) {
    take_coarse(nats);
    return;
  }
  fine_ = nats;
  sums().solve_weights();
  part_ = 0;
  stage_ = Stage::kParts;
}

template <class Real>
void BoundedStem<Real>::take_coarse(Real nats) {
  if (nats > nats_) {
    nats_ = nats;
    best_ = tried_;
  }
  stage_ = Stage::kLay;
  if (++tried_ < kSpeeds + kEnds * kEnds) {
    return;
  }
  stage_ = Stage::kDone;
  if (best_ > 0) {
    begin_sums(kLagBins);
    confirming_ = true;
  }
}

template <class Real>
void BoundedStem<Real>::sum_part() {
  constexpr std::size_t kCount = SpokenParts<Real>::kCount;
  const std::size_t reach = sums().reach();
  const std::size_t rows = count_ - reach;
  const Real error = sums().error_of(y_, stem(), reach + part_ * rows / kCount,
                                     reach + (part_ + 1) * rows / kCount);
  tried_ == 0 ? parts_.set(part_, error) : parts_.less(part_, error);
  if (++part_ < kCount) {
    return;
  }
  stage_ = Stage::kLay;
  if (tried_ > 0) {
    nats_ = std::max(std::min(nats_, parts_.without_excess(fine_)), Real(0));
    stage_ = Stage::kDone;
  }
  tried_ = best_;
}

template <class Real>
int BoundedStem<Real>::piece() {
  switch (stage_) {
    case Stage::kThin:
      y_ = thin_out(window_.y, thinning_, window_.scratch.last(count_));
      stage_ = Stage::kOutput;
      break;
    case Stage::kLay:
      lay();
      break;
    case Stage::kOutput:
    case Stage::kInput: {
      const bool output = stage_ == Stage::kOutput;
      const std::size_t end = std::min(next_ + kRows, count_);
      sums().add(y_, output ? std::span<const Real>() : stem(), next_, end);
      next_ = end;
      if (next_ == count_) {
        output ? lay() : take_error();
      }
      break;
    }
    case Stage::kParts:
      sum_part();
      break;
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
