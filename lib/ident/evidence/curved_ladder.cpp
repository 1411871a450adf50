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
  known_ = first_ < last_ && begin();
  done_ = !known_;
}

template <class Real>
bool CurvedLadder<Real>::begin() {
  tried_ = first_;
  return passes_.begin(kCoarseLagBins, PassOf::kStemAndSquare);
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

// Of the stem that is tried: nats after its cost.
template <class Real>
typename CurvedLadder<Real>::Best CurvedLadder<Real>::worth(Real gained) const {
  const bool fitted = tried_ == last_;
  const int parameters = fitted ? fitted_.parameters : 2;
  return {gained - static_cast<Real>(parameters) / Real(2) *
                       elementary::log(static_cast<Real>(passes_.rows())),
          fitted ? fitted_.band : rung_band(tried_ / kKinds, passes_.window().span)};
}

template <class Real>
void CurvedLadder<Real>::take_nats() {
  const Real gained = passes_.nats();
  if (!passes_.follows()) {
    Best& best = best_[beside_ ? 1 : 0];
    const Best found = worth(gained);
    best = found.nats > best.nats ? found : best;
    ++tried_;
  }
  if (tried_ < last_ || (tried_ == last_ && fitted_.parameters > 0)) {
    valve_ = valve();
    passes_.next(PassOf::kStemAndSquare);
  } else if (!beside_ && !setpoint_.empty()) {
    beside_ = true;
    begin();
    passes_.stand_beside(setpoint_);
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

template <class Real>
Real CurvedLadder<Real>::nats() const {
  return beside_ ? std::min(best_[0].nats, best_[1].nats) : best_[0].nats;
}

template <class Real>
Real CurvedLadder<Real>::narrower_band() const {
  return beside_ ? std::min(best_[0].band, best_[1].band) : best_[0].band;
}

template <class Real>
Real CurvedLadder<Real>::wider_band() const {
  return beside_ ? std::max(best_[0].band, best_[1].band) : best_[0].band;
}

template class CurvedLadder<float>;
template class CurvedLadder<double>;

}  // namespace ident
