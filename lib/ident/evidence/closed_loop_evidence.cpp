#include "ident/evidence/closed_loop_evidence.hpp"

#include <algorithm>

#include "ident/base/elementary.hpp"

namespace ident {
namespace {

// Beside u rungs are tried from a fifth of the swing on, so many above the lowest, each
// three quarters wider than the one before.
constexpr int kRungsToFifth = 11;
constexpr int kRungsBesideU = 4;

}  // namespace

template <class Real>
void ClosedLoopEvidence<Real>::start(const EvidenceWindow<Real>& window,
                                     Ladder<Real>& ladder) {
  ladder_ = &ladder;
  ladder = {};
  begin(window, kSlips, kLadderLagBins);
}

template <class Real>
void ClosedLoopEvidence<Real>::start_with(const EvidenceWindow<Real>& window,
                                          const StickSlipValve<Real>& valve,
                                          int parameters, std::span<const LagBin> bins) {
  ladder_ = nullptr;
  given_ = valve;
  begin(window, parameters, bins);
}

template <class Real>
void ClosedLoopEvidence<Real>::start_beside_setpoint(const EvidenceWindow<Real>& window,
                                                     const StickSlipValve<Real>& valve,
                                                     std::span<const Real> setpoint) {
  start_with(window, valve, 0);
  passes_.stand_beside(setpoint);
}

template <class Real>
bool ClosedLoopEvidence<Real>::start_beside_best(const EvidenceWindow<Real>& window) {
  if (best_rung_ < 0) {
    return false;
  }
  start_with(window, valve_of(best_rung_, best_slip_), 0, kCoarseLagBins);
  beside_ = true;
  rung_ = rungs_.first + kRungsToFifth;
  return true;
}

template <class Real>
void ClosedLoopEvidence<Real>::go_on_with(const StickSlipValve<Real>& valve) {
  given_ = valve;
  done_ = false;
  begin_stem(Stem::kGiven);
}

template <class Real>
void ClosedLoopEvidence<Real>::begin(const EvidenceWindow<Real>& window, int parameters,
                                     std::span<const LagBin> bins) {
  passes_.start(window);
  best_ = cost_ = detectable_ = 0;
  hoped_ = {};
  best_rung_ = -1;
  part_ = Part::kTries;
  beside_ = false;
  divides_ = !kSmallSizes && ladder_ == nullptr && bins.data() == kLagBins.data();
  done_ = !passes_.begin(bins);
  if (done_) {
    return;
  }
  cost_ = cost_of<Real>(parameters, passes_.rows());
  rungs_ = rungs_within(window.swing, window.span);
}

template <class Real>
void ClosedLoopEvidence<Real>::begin_stem(Stem stem) {
  const EvidenceWindow<Real>& window = passes_.window();
  stem_ = stem;
  if (stem == Stem::kRung) {
    // Not by valve_of: on a device this is the only one, laid in place.
    valve_ = {rung_valve<Real>(rung_, slip_, window.span), window.u[0]};
  } else if (stem == Stem::kGiven || stem == Stem::kGivenWithU) {
    valve_ = given_;
  }
  strokes_ = direction_ = 0;
  position_ = window.u[0];
  if (part_ == Part::kPlants) {
    passes_.next(PassOf::kPlanted);
  } else if (kStemSearch && part_ == Part::kRefutes) {
    passes_.next(PassOf::kStemAndNewest);
  } else {
    const bool beside = kStemSearch && stem == Stem::kGivenWithU;
    passes_.next(beside ? PassOf::kStemAndU : PassOf::kStem);
  }
}

template <class Real>
Real ClosedLoopEvidence<Real>::move_stem(Real u) {
  if (stem_ == Stem::kRests) {
    return 0;
  }
  const Real x = valve_.step(u);
  if (x != position_) {
    const int direction = x > position_ ? 1 : -1;
    strokes_ += direction != direction_ ? 1 : 0;
    direction_ = direction;
    position_ = x;
  }
  return x;
}

// A valve that sticks speaks at most of its strokes; a wrong model form, or a load that
// met a stroke, in one place: (E14).
template <class Real>
void ClosedLoopEvidence<Real>::take_error() {
  if (!kSmallSizes && passes_.divided()) {
    nats_ = passes_.follows() ? nats_ : passes_.without_excess(nats_);
    take_nats();
    return;
  }
  nats_ = passes_.nats();
  if (kStemSearch && part_ == Part::kRefutes) {
    take_refuted();
  } else if (!kSmallSizes && divides_) {
    passes_.divide();
  } else {
    take_nats();
  }
}

template <class Real>
void ClosedLoopEvidence<Real>::take_nats() {
  if (passes_.follows()) {
    after_u();
    return;
  }
  switch (stem_) {
    case Stem::kGiven:
      best_ = nats_;
      done_ = true;
      return;
    case Stem::kGivenWithU:
      if constexpr (kStemSearch) {
        next_beside();
      }
      return;
    case Stem::kRests:
      for (int rung = rungs_.last + 1; rung < kRungs; ++rung) {
        for (int slip = 0; slip < kSlips; ++slip) {
          rung_nats(rung, slip) = nats_;
        }
      }
      rung_ = rungs_.first;
      slip_ = 0;
      next_rung();
      return;
    case Stem::kRung:
      take_rung();
      return;
  }
}

// Where u remembers what of y is between the samples, a stem alone foretells less than u
// even if it is the valve's.
template <class Real>
void ClosedLoopEvidence<Real>::next_beside() {
  // (E17) Half a nat is what each weight brings by chance.
  best_ = std::max(best_, nats_ - Real(0.5) * static_cast<Real>(passes_.sums().bins()));
  if (rung_ > rungs_.last || best_ > Real(kBends)) {
    done_ = true;
    return;
  }
  given_ = valve_of(rung_, 0);
  rung_ += kRungsBesideU;
  begin_stem(Stem::kGivenWithU);
}

template <class Real>
void ClosedLoopEvidence<Real>::after_u() {
  if (ladder_ == nullptr) {
    begin_stem(kStemSearch && beside_ ? Stem::kGivenWithU : Stem::kGiven);
    return;
  }
  if (kConfirms && part_ == Part::kTries) {
    begin_stem(Stem::kRests);
    return;
  }
  if (!divides_) {
    passes_.sums().solve_weights();
  }
  part_ = Part::kPlants;
  rung_ = rungs_.first;
  slip_ = 0;
  next_planted();
}

template <class Real>
bool ClosedLoopEvidence<Real>::step(int budget) {
  for (int left = budget * kUnit; left > 0 && !done_;) {
    left -=
        passes_.piece([this](Real u) { return move_stem(u); },
                      [this] { part_ == Part::kPlants ? take_planted() : take_error(); });
  }
  return done_;
}

template class ClosedLoopEvidence<float>;
template class ClosedLoopEvidence<double>;

}  // namespace ident
