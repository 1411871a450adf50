// The rungs of the ladder, one after the other: what each says, which band would have
// shown, and whether the best stands up to fine lags.
#include <algorithm>
#include <cmath>

#include "ident/base/elementary.hpp"
#include "ident/evidence/closed_loop_evidence.hpp"

namespace ident {
namespace {

// Noise is costly to look at: not at every rung.
constexpr int kRungsOfNoise = 2;

}  // namespace

template <class Real>
void ClosedLoopEvidence<Real>::take_rung() {
  if (kConfirms && confirming_) {
    best_ = std::min(best_, nats_);
    done_ = true;
    return;
  }
  rung_nats(rung_, slip_) = nats_;
  if (best_rung_ < 0 || nats_ > best_) {
    best_ = nats_;
    best_rung_ = rung_;
    best_slip_ = slip_;
    best_strokes_ = strokes_;
  }
  if (++slip_ == kSlips) {
    slip_ = 0;
    ++rung_;
  }
  next_rung();
}

template <class Real>
void ClosedLoopEvidence<Real>::next_rung() {
  rung_ > rungs_.last ? confirm() : begin_stem(Stem::kRung);
}

// What coarse lags say of the best rung, which alone says little of cycles as short as a
// few of them, has to stand up to fine ones.
template <class Real>
void ClosedLoopEvidence<Real>::confirm() {
  done_ = true;
  if constexpr (kConfirms) {
    if (best_rung_ >= 0 && passes_.begin(kLagBins)) {
      confirming_ = true;
      divides_ = !kSmallSizes;
      done_ = false;
    }
  }
}

template <class Real>
void ClosedLoopEvidence<Real>::keep_band(Real band, bool beyond_noise) {
  if constexpr (kStemSearch) {
    (beyond_noise ? detectable_ : hoped_.hoped_band) = band;
    slip_ = 0;
  } else {
    detectable_ = band;
  }
}

// Of u the newest lags know y between the samples, and their weights are the controller's
// rather than the valve's. A stem rests through what is small and quick: its weights are
// what the valve may do. The columns that a band has to leave behind are those of u
// again.
template <class Real>
void ClosedLoopEvidence<Real>::take_smooth_weights() {
  if (stem_ == Stem::kSmooth) {
    passes_.sums().solve_weights();
    begin_stem(Stem::kFollowsAgain);
    return;
  }
  planting_ = true;
  next_planted();
}

template <class Real>
void ClosedLoopEvidence<Real>::take_planted() {
  const bool noise = beyond_noise();
  const Real rows = static_cast<Real>(passes_.rows());
  Real planted = passes_.sums().planted();
  if (noise) {
    const Real by_noise = passes_.sums().planted_by_noise() * passes_.error_of_u() / rows;
    const Real root = std::max(std::sqrt(planted) - std::sqrt(by_noise), Real(0));
    planted = root * root;
  }
  const Real nats =
      rows / Real(2) * elementary::log(Real(1) + planted / passes_.error_of_u());
  if (nats < Real(kShows)) {
    slip_ = 0;
    rung_ += noise ? kRungsOfNoise : 1;
  } else if (++slip_ == kSlips) {
    keep_band(rung_band<Real>(rung_, passes_.window().span), noise);
    if (kStemSearch && !noise) {
      planting_ = false;
      begin_stem(Stem::kSmooth);
      return;
    }
  }
  next_planted();
}

// From the narrowest band up, until one shows whatever its slip; from there, where stems
// are searched, until one does so beyond the noise of the weights.
template <class Real>
void ClosedLoopEvidence<Real>::next_planted() {
  if (rung_ > rungs_.last || detectable_ > Real(0)) {
    planting_ = false;
    if constexpr (!kConfirms) {
      begin_stem(Stem::kRests);
      return;
    }
    rung_ = best_rung_;
    slip_ = best_slip_;
  }
  begin_stem(Stem::kRung);
}

template <class Real>
LadderFinding<Real> ClosedLoopEvidence<Real>::finding() const {
  LadderFinding<Real> found;
  found.predicted = predicted();
  found.detectable_band = detectable_;
  if constexpr (kStemSearch) {
    found.hoped_band = hoped_.hoped_band;
  }
  if (best_rung_ < 0) {
    return found;
  }
  found.nats = nats();
  found.strokes = best_strokes_;
  int lowest = best_rung_;
  int highest = best_rung_;
  const Real least = rung_nats(best_rung_, best_slip_) - Real(kWithinNats);
  for (int rung = rungs_.first; rung <= rungs_.last; ++rung) {
    for (int slip = 0; slip < kSlips; ++slip) {
      if (rung_nats(rung, slip) > least) {
        lowest = std::min(lowest, rung);
        highest = std::max(highest, rung);
      }
    }
  }
  lay_interval(found, best_rung_, lowest, highest, passes_.window().span);
  return found;
}

#define STICKBAND_INSTANTIATE(Real)                              \
  template void ClosedLoopEvidence<Real>::take_smooth_weights(); \
  template void ClosedLoopEvidence<Real>::take_rung();           \
  template void ClosedLoopEvidence<Real>::next_rung();           \
  template void ClosedLoopEvidence<Real>::take_planted();        \
  template void ClosedLoopEvidence<Real>::next_planted();        \
  template LadderFinding<Real> ClosedLoopEvidence<Real>::finding() const;
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)

}  // namespace ident
