#include "ident/evidence/curved_ladder.hpp"

#include <algorithm>
#include <limits>

#include "ident/base/elementary.hpp"

namespace ident {
namespace {

constexpr std::size_t kRows = 16;
constexpr int kFollows = -1;  // no stem, u itself

}  // namespace

template <class Real>
void CurvedLadder<Real>::start(const EvidenceWindow<Real>& window,
                               std::span<const Real> setpoint,
                               const FittedStem<Real>& fitted) {
  *this = {};
  window_ = window;
  fitted_ = fitted;
  thinning_ = evidence_thinning(window);
  count_ = window.u.size() / thinning_;
  const auto moves = [&](Real sp) { return sp != setpoint[0]; };
  if (std::any_of(setpoint.begin(), setpoint.end(), moves)) {
    setpoint_ = setpoint;
  }
  const auto fits = [&](int rung) {
    const Real band = rung_band(rung, window_.span);
    return band >= Real(ClosedLoopEvidence<double>::kLowestShare) * window_.swing &&
           band <= Real(ClosedLoopEvidence<double>::kHighestShare) * window_.swing;
  };
  for (int rung = 0; rung < kRungs; ++rung) {
    if (fits(rung)) {
      first_ = last_ == 0 ? rung * kKinds : first_;
      last_ = (rung + 1) * kKinds;
    }
  }
  begin_sums();
  known_ = count_ >= next_ + kFewestRows && first_ < last_;
  stage_ = known_ ? Stage::kThin : Stage::kDone;
}

template <class Real>
void CurvedLadder<Real>::begin_sums() {
  sums().start(lag_bins_for(count_, kCoarseLagBins));
  if (beside_) {
    sums().stand_beside({setpoint_, thinning_});
  }
  next_ = sums().reach();
  tried_ = kFollows;
  best_[beside_ ? 1 : 0].nats = std::numeric_limits<Real>::lowest();
  stage_ = Stage::kOutput;
}

// At each rung, behind those of the ladder, the last of them once more, sticking after
// each slip.
template <class Real>
StickSlipValve<Real> CurvedLadder<Real>::valve() const {
  if (tried_ == last_) {
    return fitted_.valve;
  }
  if (tried_ == kFollows) {
    return {{}, window_.u[0]};
  }
  const int kind = tried_ % kKinds;
  ValveFriction<Real> friction =
      rung_valve(tried_ / kKinds, std::min(kind, kSlips - 1), window_.span);
  if (kind == kSlips) {
    friction.motion = SlipMotion::kResticks;
  }
  return {friction, window_.u[0]};
}

template <class Real>
void CurvedLadder<Real>::lay() {
  StickSlipValve<Real> moved = valve();
  Real mean = 0;
  for (std::size_t t = 0; t < count_; ++t) {
    Real sum = 0;
    for (std::size_t k = 0; k < thinning_; ++k) {
      sum += moved.step(window_.u[t * thinning_ + k]);
    }
    stem()[t] = sum / static_cast<Real>(thinning_);
    mean += stem()[t];
  }
  sums().begin_bent_input(mean / static_cast<Real>(count_));
  next_ = sums().reach();
  stage_ = Stage::kInput;
}

// Of the stem that is tried: nats after its cost.
template <class Real>
typename CurvedLadder<Real>::Best CurvedLadder<Real>::worth(Real gained) const {
  const bool fitted = tried_ == last_;
  const int parameters = fitted ? fitted_.parameters : 2;
  const Real rows = static_cast<Real>(count_ - sums().reach());
  return {rows / Real(2) * gained -
              static_cast<Real>(parameters) / Real(2) * elementary::log(rows),
          fitted ? fitted_.band : rung_band(tried_ / kKinds, window_.span)};
}

template <class Real>
void CurvedLadder<Real>::take_error() {
  const Real log_error = elementary::log(sums().error());
  Best& best = best_[beside_ ? 1 : 0];
  if (tried_ == kFollows) {
    log_follows_ = log_error;
    tried_ = first_;
  } else {
    const Best found = worth(log_follows_ - log_error);
    best = found.nats > best.nats ? found : best;
    ++tried_;
  }
  if (tried_ < last_ || (tried_ == last_ && fitted_.parameters > 0)) {
    lay();
  } else if (!beside_ && !setpoint_.empty()) {
    beside_ = true;
    begin_sums();
  } else {
    stage_ = Stage::kDone;
  }
}

template <class Real>
int CurvedLadder<Real>::piece() {
  switch (stage_) {
    case Stage::kThin:
      y_ = thin_out(window_.y, thinning_, window_.scratch.last(count_));
      stage_ = Stage::kOutput;
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
    case Stage::kDone:
      break;
  }
  return kUnit;
}

template <class Real>
bool CurvedLadder<Real>::step(int budget) {
  for (int left = budget * kUnit; left > 0 && stage_ != Stage::kDone;) {
    left -= piece();
  }
  return stage_ == Stage::kDone;
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
