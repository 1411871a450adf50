#include "ident/evidence/closed_loop_evidence.hpp"

#include <algorithm>

#include "ident/base/elementary.hpp"

namespace ident {
namespace {

constexpr std::size_t kRowsOfOutput = 64;
constexpr std::size_t kRowsOfInput = 16;
constexpr std::size_t kSamplesOfStem = 1024;
// Beside u rungs are tried from a fifth of the swing on, each three quarters wider than
// the one before.
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
  sums().stand_beside({setpoint, thinning_});
}

template <class Real>
bool ClosedLoopEvidence<Real>::start_beside_best(const EvidenceWindow<Real>& window) {
  if (best_rung_ < 0) {
    return false;
  }
  start_with(window, {rung_valve<Real>(best_rung_, best_slip_, window.span), window.u[0]},
             0, kCoarseLagBins);
  beside_ = true;
  rung_ = first_rung_ + kRungsToFifth;
  return true;
}

template <class Real>
void ClosedLoopEvidence<Real>::go_on_with(const StickSlipValve<Real>& valve) {
  given_ = valve;
  begin_stem(Stem::kGiven);
}

template <class Real>
void ClosedLoopEvidence<Real>::begin(const EvidenceWindow<Real>& window, int parameters,
                                     std::span<const LagBin> bins) {
  window_ = window;
  best_ = cost_ = detectable_ = 0;
  hoped_ = {};
  best_rung_ = -1;
  predicted_ = 0;
  planting_ = confirming_ = beside_ = false;
  divides_ = !kSmallSizes && ladder_ == nullptr && bins.data() == kLagBins.data();
  thinning_ = evidence_thinning(window);
  count_ = window.u.size() / thinning_;
  begin_sums(bins);
  if (predicted_ == 0) {
    stage_ = Stage::kDone;
    return;
  }
  cost_ = static_cast<Real>(parameters) / Real(2) *
          elementary::log(static_cast<Real>(predicted_));
  first_rung_ = kRungs;
  last_rung_ = -1;
  for (int rung = 0; rung < kRungs; ++rung) {
    const Real band = rung_band<Real>(rung, window.span);
    if (band >= Real(kLowestShare) * window.swing &&
        band <= Real(kHighestShare) * window.swing) {
      first_rung_ = std::min(first_rung_, rung);
      last_rung_ = rung;
    }
  }
  stage_ = Stage::kThin;
}

// Leaves what is predicted at 0 where the window is too short.
template <class Real>
void ClosedLoopEvidence<Real>::begin_sums(std::span<const LagBin> bins) {
  sums().start(lag_bins_for(count_, bins));
  const std::size_t reach = sums().reach();
  predicted_ = count_ < reach + kFewestRows ? 0 : count_ - reach;
  next_ = reach;
}

template <class Real>
int ClosedLoopEvidence<Real>::add_rows() {
  const bool output = stage_ == Stage::kOutput;
  const std::size_t end =
      std::min(next_ + (output ? kRowsOfOutput : kRowsOfInput), count_);
  sums().add(y_, output ? std::span<const Real>() : stem_positions(), next_, end);
  next_ = end;
  if (next_ == count_) {
    output ? begin_stem(Stem::kFollows) : take_error();
  }
  return output ? kUnit : kUnit / 2;
}

template <class Real>
void ClosedLoopEvidence<Real>::begin_stem(Stem stem) {
  stem_ = stem;
  if (stem == Stem::kRung) {
    valve_ = {rung_valve<Real>(rung_, slip_, window_.span), window_.u[0]};
  } else if (stem == Stem::kGiven || stem == Stem::kGivenWithU) {
    valve_ = given_;
  } else if (kStemSearch && stem == Stem::kSmooth) {
    valve_ = {rung_valve<Real>(first_rung_ + kRungsToFifth, 0, window_.span),
              window_.u[0]};
  }
  strokes_ = direction_ = 0;
  position_ = window_.u[0];
  next_ = 0;
  stage_ = Stage::kLay;
}

template <class Real>
Real ClosedLoopEvidence<Real>::move_stem(Real u) {
  const Real x = valve_.step(u);
  if (x != position_) {
    const int direction = x > position_ ? 1 : -1;
    strokes_ += direction != direction_ ? 1 : 0;
    direction_ = direction;
    position_ = x;
  }
  return x;
}

// Means of the stem, of what it lacks of u where a band is planted.
template <class Real>
int ClosedLoopEvidence<Real>::lay_some() {
  const std::span<Real> x = stem_positions();
  const std::size_t end = std::min(next_ + kSamplesOfStem / thinning_, count_);
  for (; next_ < end; ++next_) {
    Real sum = 0;
    for (std::size_t k = 0; k < thinning_; ++k) {
      const Real u = window_.u[next_ * thinning_ + k];
      switch (stem_) {
        case Stem::kFollows:
        case Stem::kFollowsAgain:
          sum += u;
          break;
        case Stem::kRests:
          break;
        case Stem::kRung:
        case Stem::kGiven:
        case Stem::kGivenWithU:
        case Stem::kSmooth:
          sum += move_stem(u) - (planting_ ? u : Real(0));
          break;
      }
    }
    x[next_] = sum / static_cast<Real>(thinning_);
  }
  if (next_ == count_) {
    next_ = sums().reach();
    if (planting_) {
      sums().begin_planted();
      stage_ = Stage::kPlant;
    } else {
      const bool beside = kStemSearch && stem_ == Stem::kGivenWithU;
      sums().begin_input({beside ? window_.u : std::span<const Real>(), thinning_});
      stage_ = Stage::kInput;
    }
  }
  return kUnit / 2;
}

template <class Real>
void ClosedLoopEvidence<Real>::take_error() {
  const Real error = sums().error();
  if (kStemSearch && (stem_ == Stem::kSmooth || stem_ == Stem::kFollowsAgain)) {
    take_smooth_weights();
    return;
  }
  if (stem_ == Stem::kFollows) {
    error_follows_ = error;
    log_follows_ = elementary::log(error);
  }
  nats_ =
      static_cast<Real>(predicted_) / Real(2) * (log_follows_ - elementary::log(error));
  if (divides_) {
    sums().solve_weights();
    part_ = 0;
    stage_ = Stage::kParts;
    return;
  }
  take_nats();
}

// A valve that sticks speaks at most of its strokes; a wrong model form, or a load that
// met a stroke, in one place.
template <class Real>
int ClosedLoopEvidence<Real>::sum_part() {
  constexpr std::size_t kCount = SpokenParts<Real>::kCount;
  const std::size_t reach = sums().reach();
  const Real error =
      sums().error_of(y_, stem_positions(), reach + part_ * predicted_ / kCount,
                      reach + (part_ + 1) * predicted_ / kCount);
  const bool follows = stem_ == Stem::kFollows;
  follows ? parts_.set(part_, error) : parts_.less(part_, error);
  if (++part_ == kCount) {
    nats_ = follows ? nats_ : parts_.without_excess(nats_);
    take_nats();
  }
  return kUnit;
}

template <class Real>
void ClosedLoopEvidence<Real>::take_nats() {
  switch (stem_) {
    case Stem::kFollows:
      after_u();
      return;
    case Stem::kGiven:
      best_ = nats_;
      stage_ = Stage::kDone;
      return;
    case Stem::kGivenWithU:
      if constexpr (kStemSearch) {
        next_beside();
      }
      return;
    case Stem::kRests:
      for (int rung = last_rung_ + 1; rung < kRungs; ++rung) {
        for (int slip = 0; slip < kSlips; ++slip) {
          rung_nats(rung, slip) = nats_;
        }
      }
      rung_ = first_rung_;
      slip_ = 0;
      next_rung();
      return;
    case Stem::kRung:
      take_rung();
      return;
    case Stem::kSmooth:
    case Stem::kFollowsAgain:
      return;
  }
}

// Where u remembers what of y is between the samples, a stem alone foretells less than u
// even if it is the valve's.
template <class Real>
void ClosedLoopEvidence<Real>::next_beside() {
  // (E17) Half a nat is what each weight brings by chance.
  best_ = std::max(best_, nats_ - Real(0.5) * static_cast<Real>(sums().bins()));
  if (rung_ > last_rung_ || best_ > Real(kBends)) {
    stage_ = Stage::kDone;
    return;
  }
  given_ = {rung_valve<Real>(rung_, 0, window_.span), window_.u[0]};
  rung_ += kRungsBesideU;
  begin_stem(Stem::kGivenWithU);
}

template <class Real>
void ClosedLoopEvidence<Real>::after_u() {
  if (ladder_ == nullptr) {
    begin_stem(kStemSearch && beside_ ? Stem::kGivenWithU : Stem::kGiven);
    return;
  }
  if (kConfirms && !confirming_) {
    begin_stem(Stem::kRests);
    return;
  }
  if (!divides_) {
    sums().solve_weights();
  }
  planting_ = true;
  rung_ = first_rung_;
  slip_ = 0;
  next_planted();
}

template <class Real>
int ClosedLoopEvidence<Real>::piece() {
  switch (stage_) {
    case Stage::kThin:
      y_ = thin_out(window_.y, thinning_, window_.scratch.last(count_));
      stage_ = Stage::kOutput;
      return kUnit / 2;
    case Stage::kOutput:
    case Stage::kInput:
      return add_rows();
    case Stage::kLay:
      return lay_some();
    case Stage::kParts:
      if constexpr (!kSmallSizes) {
        return sum_part();
      }
      break;
    case Stage::kPlant:
      return plant_some();
    case Stage::kDone:
      break;
  }
  return kUnit;
}

template <class Real>
bool ClosedLoopEvidence<Real>::step(int budget) {
  for (int left = budget * kUnit; left > 0 && stage_ != Stage::kDone;) {
    left -= piece();
  }
  return stage_ == Stage::kDone;
}

template class ClosedLoopEvidence<float>;
template class ClosedLoopEvidence<double>;

}  // namespace ident
