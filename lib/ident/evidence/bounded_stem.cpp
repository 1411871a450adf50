#include "ident/evidence/bounded_stem.hpp"

#include <algorithm>

#include "ident/base/elementary.hpp"

namespace ident {
namespace {

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
  passes_.start(window);
  done_ = !(window.period > Real(0)) || !passes_.begin(kCoarseLagBins);
}

template <class Real>
void BoundedStem<Real>::bound_by(int stem) {
  const EvidenceWindow<Real>& window = passes_.window();
  const auto [low, high] = std::minmax_element(window.u.begin(), window.u.end());
  low_ = *low;
  high_ = *high;
  speed_ = 0;
  if (stem <= kSpeeds) {
    speed_ = Real(2) * Real(kSlowest) * window.swing / window.period;
    for (int k = 1; k < stem; ++k) {
      speed_ *= Real(kFaster);
    }
  } else {
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
void BoundedStem<Real>::lay(int stem) {
  tried_ = stem;
  bound_by(stem);
  position_ = std::clamp(passes_.window().u[0], low_, high_);
  passes_.next();
}

template <class Real>
void BoundedStem<Real>::take_nats() {
  if (passes_.divided()) {
    take_parts();
    return;
  }
  const Real nats = passes_.nats() - elementary::log(static_cast<Real>(passes_.rows()));
  if (!confirming_) {
    take_coarse(nats);
    return;
  }
  fine_ = nats;
  passes_.divide();
}

template <class Real>
void BoundedStem<Real>::take_coarse(Real nats) {
  if (nats > nats_) {
    nats_ = nats;
    best_ = tried_;
  }
  if (tried_ + 1 < kSpeeds + kEnds * kEnds) {
    lay(tried_ + 1);
    return;
  }
  confirming_ = best_ > 0 && passes_.begin(kLagBins);
  done_ = !confirming_;
}

template <class Real>
void BoundedStem<Real>::take_parts() {
  if (passes_.follows()) {
    lay(best_);
    return;
  }
  nats_ = std::max(std::min(nats_, passes_.without_excess(fine_)), Real(0));
  done_ = true;
}

template <class Real>
bool BoundedStem<Real>::step(int budget) {
  for (int left = budget * kUnit; left > 0 && !done_;) {
    left -= passes_.piece([this](Real u) { return position_ = moved(position_, u); },
                          [this] { take_nats(); });
  }
  return done_;
}

template class BoundedStem<float>;
template class BoundedStem<double>;

}  // namespace ident
