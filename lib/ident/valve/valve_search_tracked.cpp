// The part of the search for a valve with a memory in which a SlipTracker sees how well
// each member of the beam can follow the whole window.
#include <algorithm>

#include "ident/base/sort_few.hpp"
#include "ident/valve/valve_search.hpp"

namespace ident {
namespace {

// The tracker's rounds, first for each member of the beam, then for the best, and how
// wide its bundle is at first and after each round.
constexpr int kSiftRounds = 4;
constexpr int kTrackRounds = 10;
constexpr double kSiftSpread = 0.5;
constexpr double kTrackSpread = 0.3;
constexpr double kNarrowing = 0.7;
constexpr double kLeastSpread = 0.01;
constexpr double kSameMisfit = 1.03;

}  // namespace

// The beam knows the first cycles only: the tracker sees how well each member can follow
// all of them.
template <class Real>
void ValveSearch<Real>::start_tracking() {
  stage_ = Stage::kTrack;
  first_used_ = pass_.used();
  index_ = 0;
  track_member();
}

template <class Real>
void ValveSearch<Real>::track_member() {
  if (sifted_) {
    const bool depart = index_ >= beam_size_;
    const int from = depart ? index_ % std::min(beam_size_, kLeft) : index_;
    State state = tracked_[from];
    if (depart && (index_ - beam_size_) / kLeft % 2 == 1) {
      SlipMotion& motion = state.model.friction.motion;
      motion = motion == SlipMotion::kStops ? SlipMotion::kResticks : SlipMotion::kStops;
    }
    tracker_.resume(state, depart);
    begin_rounds();
  } else {
    pass_.place(beam_[index_]);
    asked_ = true;
  }
}

template <class Real>
void ValveSearch<Real>::begin_rounds() {
  round_ = 0;
  spread_ = sifted_ ? Real(kTrackSpread) : Real(kSiftSpread);
  tracker_.begin_round(spread_);
}

template <class Real>
void ValveSearch<Real>::track_next() {
  if (answered()) {
    tracker_.start(window(), beam_[index_], pass_.used(), x_, scratch_, *stems_,
                   pass_.regression());
    begin_rounds();
    return;
  }
  if (!tracker_.step()) {
    return;
  }
  if (++round_ < (sifted_ ? kTrackRounds : kSiftRounds)) {
    spread_ = std::max(spread_ * Real(kNarrowing), Real(kLeastSpread));
    tracker_.begin_round(spread_);
    return;
  }
  const bool departed = sifted_ && index_ >= beam_size_;
  State& place = tracked_[departed ? beam_size_ - 1 : index_];
  if (!departed || tracker_.best().misfit < place.misfit) {
    place = tracker_.best();
  }
  if (sifted_ && !departed) {
    stage_ = Stage::kTry;
    placing_ = true;
    round_ = 0;
    pass_.use(whole());
    return;
  }
  track_another();
}

// The next member of the beam, or one of the best again, or on with those.
template <class Real>
void ValveSearch<Real>::track_another() {
  ++index_;
  const int kept = sifted_ ? std::min(beam_size_, kTracked) : beam_size_;
  if (index_ >= kept) {
    sort_few(tracked_.begin(), tracked_.begin() + beam_size_,
             [](const State& a, const State& b) {
               return a.followed == b.followed ? a.misfit < b.misfit : a.followed;
             });
    if (!sifted_) {
      stage_ = Stage::kSift;
      return;
    }
    index_ = std::max(index_, beam_size_);
    if (index_ == beam_size_ + kDepartures || settled()) {
      stage_ = Stage::kPlace;
      placed_ = kept;
      beam_size_ = std::min(beam_size_, kKept);
      round_ = 0;
      index_ = 0;
      return;
    }
  }
  track_member();
}

// Whether any stem was followed better than the best valve so far, which the same
// observer keeps in step; loads move both alike.
template <class Real>
void ValveSearch<Real>::sift() {
  const ValveModel<Real>& best = best_of_all();
  if (answered()) {
    tracker_.measure(best.poles);
    measuring_ = true;
    return;
  }
  if (!measuring_) {
    pass_.use(whole());
    pass_.place(best);
    asked_ = true;
    return;
  }
  if (!tracker_.step()) {
    return;
  }
  measuring_ = false;
  pass_.use(first_used_);
  const Real misfit = tracker_.misfit();
  const Real tracked = tracked_[0].misfit;
  if (!tracked_[0].followed ||
      !(tracked * tracked < Real(kPromising) * misfit * misfit)) {
    search_nearby(SlipMotion::kStops);
    return;
  }
  rival_ = best.fit.error;
  sifted_ = true;
  index_ = 0;
  stage_ = Stage::kTrack;
  track_member();
}

// Whether there is nothing to be gained: a valve that moves otherwise does better already
// though it runs free, or the best rounds ended at the same one.
template <class Real>
bool ValveSearch<Real>::settled() const {
  const auto& best = tracked_[0];
  const Real samples = static_cast<Real>(whole());
  if (rival_ < samples * best.misfit * best.misfit) {
    return true;
  }
  if (beam_size_ < kAgreeing) {
    return false;
  }
  for (int k = 1; k < kAgreeing; ++k) {
    const auto& other = tracked_[k];
    if (other.misfit > Real(kSameMisfit) * best.misfit ||
        !alike(best.model, other.model)) {
      return false;
    }
  }
  return true;
}

// What a tracked valve that ran free leaves of y.
template <class Real>
void ValveSearch<Real>::take_tried() {
  if (pass_.structure() < Real(kWhiteResidual)) {
    search_nearby(SlipMotion::kStops);
    return;
  }
  pass_.use(first_used_);
  stage_ = Stage::kTrack;
  track_another();
}

template <class Real>
void ValveSearch<Real>::place_next() {
  if (!place(index_, beam_[beam_size_])) {
    return;
  }
  round_ = 0;
  ++beam_size_;
  if (++index_ < placed_) {
    return;
  }
  // The first time they grow with the beam, the second time they are nearly right.
  stage_ = Stage::kGrow;
  const bool all = pass_.used() == whole();
  index_ = all ? beam_size_ - placed_ : 0;
  placed_ = all ? -1 : placed_;
  begin_polish(ValveForm::kMixed, beam_[index_], jumps());
}

#define STICKBAND_INSTANTIATE(Real)                  \
  template void ValveSearch<Real>::start_tracking(); \
  template void ValveSearch<Real>::track_member();   \
  template void ValveSearch<Real>::begin_rounds();   \
  template void ValveSearch<Real>::track_next();     \
  template void ValveSearch<Real>::track_another();  \
  template void ValveSearch<Real>::sift();           \
  template bool ValveSearch<Real>::settled() const;  \
  template void ValveSearch<Real>::take_tried();     \
  template void ValveSearch<Real>::place_next();
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)
#undef STICKBAND_INSTANTIATE

}  // namespace ident
