// The rungs of the ladder, one after the other: what each says, which band would show,
// which are refuted, and whether the best stands up to fine lags.
#include <algorithm>
#include <cmath>

#include "ident/base/elementary.hpp"
#include "ident/evidence/closed_loop_evidence.hpp"

namespace ident {
namespace {

// From one that is refuted to the next narrower one: fine lags are costly.
constexpr int kRungsDown = 2;
// A swing that is hardly more than this share of it in noise turns by noise.
constexpr double kTurnsByNoise = 0.15;

// Whether u, by its second differences, moves back and forth by noise: then a stick band
// may be wider than any swing, and u is a record of what y did between the samples.
template <class Real>
bool turns_by_noise(const EvidenceWindow<Real>& window) {
  const std::span<const Real> u = window.u;
  Real sum = 0;
  for (std::size_t t = 2; t < u.size(); ++t) {
    const Real bend = u[t] - Real(2) * u[t - 1] + u[t - 2];
    sum += bend * bend;
  }
  // White noise leaves six times its variance.
  const Real noise = Real(kTurnsByNoise) * window.swing;
  return sum > Real(6) * static_cast<Real>(u.size()) * noise * noise;
}

}  // namespace

template <class Real>
void ClosedLoopEvidence<Real>::take_rung() {
  if (kConfirms && part_ == Part::kConfirms) {
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
      part_ = Part::kConfirms;
      divides_ = !kSmallSizes;
      done_ = false;
    }
  }
}

template <class Real>
void ClosedLoopEvidence<Real>::take_planted() {
  const Real nats =
      static_cast<Real>(passes_.rows()) / Real(2) *
      elementary::log(Real(1) + passes_.sums().planted() / passes_.error_of_u());
  if (nats < Real(kShows)) {
    slip_ = 0;
    ++rung_;
  } else if (++slip_ == kSlips) {
    const Real band = rung_band<Real>(rung_, passes_.window().span);
    if constexpr (kStemSearch) {
      hoped_.hoped_band = band;
    } else {
      detectable_ = band;
    }
    rung_ = rungs_.last + 1;
  }
  next_planted();
}

// From the narrowest band up, until one shows whatever its slip.
template <class Real>
void ClosedLoopEvidence<Real>::next_planted() {
  if (rung_ <= rungs_.last) {
    begin_stem(Stem::kRung);
    return;
  }
  if (kStemSearch && turns_by_noise(passes_.window())) {
    confirm_best();
    return;
  }
  part_ = kStemSearch ? Part::kRefutes : Part::kTries;
  begin_stem(Stem::kRests);
}

template <class Real>
void ClosedLoopEvidence<Real>::confirm_best() {
  part_ = Part::kConfirms;
  rung_ = best_rung_;
  slip_ = best_slip_;
  begin_stem(Stem::kRung);
}

// (E25) From a stem that never moves down, until one may be the valve's.
template <class Real>
void ClosedLoopEvidence<Real>::take_refuted() {
  const bool refuted = nats_ < -Real(kRefutes);
  const bool rests = stem_ == Stem::kRests;
  if (refuted && (rests || ++slip_ == kSlips)) {
    if (!rests) {
      detectable_ = rung_band<Real>(rung_, passes_.window().span);
    }
    rung_ = rests ? rungs_.last : rung_ - kRungsDown;
    slip_ = 0;
  }
  if (!refuted || rung_ < rungs_.first) {
    confirm_best();
    return;
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

#define STICKBAND_INSTANTIATE(Real)                       \
  template void ClosedLoopEvidence<Real>::take_rung();    \
  template void ClosedLoopEvidence<Real>::next_rung();    \
  template void ClosedLoopEvidence<Real>::take_planted(); \
  template void ClosedLoopEvidence<Real>::take_refuted(); \
  template void ClosedLoopEvidence<Real>::confirm_best(); \
  template void ClosedLoopEvidence<Real>::next_planted(); \
  template LadderFinding<Real> ClosedLoopEvidence<Real>::finding() const;
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)

}  // namespace ident
