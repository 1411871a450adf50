#include "ident/evidence/curved_ladder.hpp"

#include <algorithm>

#include "ident/base/elementary.hpp"

namespace ident {

template <class Real>
void CurvedLadder<Real>::start(const EvidenceWindow<Real>& window,
                               std::span<const Real> setpoint,
                               const FittedStem<Real>& fitted) {
  *this = {};
  passes_.start(window);
  setpoint_ = setpoint;
  fitted_ = fitted;
  const RungRange rungs = rungs_within(window.swing, window.span);
  first_ = rungs.first * kKinds;
  last_ = (rungs.last + 1) * kKinds;
  known_ = first_ < last_ && begin(PassOf::kStem);
  done_ = !known_;
}

template <class Real>
bool CurvedLadder<Real>::begin(PassOf of_u) {
  tried_ = first_;
  const bool begun = passes_.begin(kCoarseLagBins, of_u);
  if (beside_) {
    passes_.stand_beside(setpoint_);
  }
  return begun;
}

// At each rung, behind those of the ladder, the last of them once more, sticking after
// each slip.
template <class Real>
StickSlipValve<Real> CurvedLadder<Real>::valve() const {
  if (tried_ == last_) {
    return fitted_.valve;
  }
  const EvidenceWindow<Real>& window = passes_.window();
  const int kind = tried_ % kKinds;
  ValveFriction<Real> friction =
      rung_valve(tried_ / kKinds, std::min(kind, kSlips - 1), window.span);
  if (kind == kSlips) {
    friction.motion = SlipMotion::kResticks;
  }
  return {friction, window.u[0]};
}

template <class Real>
Real CurvedLadder<Real>::band() const {
  return tried_ == last_ ? fitted_.band
                         : rung_band(tried_ / kKinds, passes_.window().span);
}

// First u alone, then, with as much memory of y, its square beside it.
template <class Real>
void CurvedLadder<Real>::take_u() {
  if (!bent_) {
    error_of_u_ = passes_.error_of_u();
    bent_ = true;
    begin(PassOf::kStemAndSquare);
    return;
  }
  const Real rows = static_cast<Real>(passes_.rows());
  best_[beside_ ? 1 : 0].curve_nats =
      rows / Real(2) * elementary::log(error_of_u_ / passes_.error_of_u()) -
      cost_of<Real>(static_cast<int>(passes_.sums().bins()), passes_.rows());
  try_next();
}

template <class Real>
void CurvedLadder<Real>::take_nats() {
  const Real gained = passes_.nats();
  if (passes_.follows()) {
    take_u();
    return;
  }
  Best& best = best_[beside_ ? 1 : 0];
  const int parameters = tried_ == last_ ? fitted_.parameters : 2;
  const Real nats = gained - cost_of<Real>(parameters, passes_.rows());
  if (nats > best.nats) {
    best.nats = nats;
    best.band = band();
  }
  ++tried_;
  try_next();
}

template <class Real>
void CurvedLadder<Real>::try_next() {
  if (tried_ < last_ || (tried_ == last_ && fitted_.parameters > 0)) {
    valve_ = valve();
    passes_.next(PassOf::kStemAndSquare);
  } else if (!beside_ && !setpoint_.empty()) {
    beside_ = true;
    bent_ = false;
    begin(PassOf::kStem);
  } else {
    done_ = true;
  }
}

template <class Real>
bool CurvedLadder<Real>::step(int budget) {
  for (int left = budget * kUnit; left > 0 && !done_;) {
    left -=
        passes_.piece([this](Real u) { return valve_.step(u); }, [this] { take_nats(); });
  }
  return done_;
}

template class CurvedLadder<float>;
template class CurvedLadder<double>;

}  // namespace ident
