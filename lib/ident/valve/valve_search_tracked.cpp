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

// Each member of the beam through the whole window, then the best at length, each of
// these running free too, then the best left again and again. If one running free
// explains everything, only what is near the best valve is still tried.
template <class Real>
void ValveSearch<Real>::track() {
  constexpr Real kFar = Real(ValvePolish<Real>::kFarJumps);
  constexpr Real kNear = Real(ValvePolish<Real>::kNearJumps);
  switch (stage_) {
    case Stage::kSiftPlaced:
      tracker_.start(window(), beam_[index_], pass_.used(), x_, scratch_, *stems_,
                     pass_.regression());
      return follow(kSiftRounds, Real(kSiftSpread), Stage::kSifted);
    case Stage::kSifted:
      tracked_[index_++] = tracker_.best();
      return sift();
    case Stage::kBestPlaced:
      tracker_.measure(best_of_all().poles);
      return begin(Trials::kMeasured, Stage::kBestMeasured);
    case Stage::kBestMeasured:
      if (!promises()) {
        return search_nearby(SlipMotion::kStops);
      }
      rival_ = best_of_all().fit.error;
      index_ = 0;
      return follow_at_length();
    case Stage::kFollowed:
      tracked_[index_] = tracker_.best();
      pass_.use(whole());
      return place(index_, Stage::kFollowedPlaced);
    case Stage::kFollowedPlaced:
      return polish_tried(kNear, Stage::kFollowedPolished);
    case Stage::kFollowedPolished:
      pass_.explain(polish_.best());
      return begin(Trials::kOne, Stage::kFollowedExplained);
    case Stage::kFollowedExplained:
      if (pass_.structure() < Real(kWhiteResidual)) {
        return search_nearby(SlipMotion::kStops);
      }
      ++index_;
      return follow_at_length();
    case Stage::kDeparted:
      if (tracker_.best().misfit < tracked_[beam_size_ - 1].misfit) {
        tracked_[beam_size_ - 1] = tracker_.best();
      }
      ++index_;
      return depart();
    case Stage::kPlaced:
      beam_[beam_size_++] = tried_;
      if (++index_ < placed_) {
        return place(index_, Stage::kPlaced);
      }
      // The first time they grow with the beam, the second time they are nearly right.
      return pass_.used() < whole() ? polish_all(Trials::kBeam, 0, kFar, Stage::kGrown)
                                    : polish_all(Trials::kBeam, beam_size_ - placed_,
                                                 kNear, Stage::kPlacedPolished);
    case Stage::kPlacedPolished:
      prune_beam(kGrown);
      return polish_all(Trials::kJobs, 0, Real(ValvePolish<Real>::kGrownJumps),
                        Stage::kRemembered);
    default:
      return;
  }
}

// The beam knows the first cycles only: the tracker sees how well each member can follow
// all of them; then how well the best valve so far can.
template <class Real>
void ValveSearch<Real>::sift() {
  if (index_ < beam_size_) {
    pass_.place(beam_[index_]);
    return begin(Trials::kOne, Stage::kSiftPlaced);
  }
  sort_tracked();
  pass_.use(whole());
  pass_.place(best_of_all());
  begin(Trials::kOne, Stage::kBestPlaced);
}

template <class Real>
void ValveSearch<Real>::follow(int rounds, Real spread, Stage then) {
  begin(Trials::kRounds, then);
  round_ = static_cast<std::int16_t>(rounds);
  spread_ = spread;
  tracker_.begin_round(spread_);
}

template <class Real>
bool ValveSearch<Real>::follow_next() {
  if (!tracker_.step()) {
    return false;
  }
  if (trials_ == Trials::kMeasured || --round_ == 0) {
    return true;
  }
  spread_ = std::max(spread_ * Real(kNarrowing), Real(kLeastSpread));
  tracker_.begin_round(spread_);
  return false;
}

template <class Real>
void ValveSearch<Real>::sort_tracked() {
  sort_few(tracked_.begin(), tracked_.begin() + beam_size_,
           [](const State& a, const State& b) {
             return a.followed == b.followed ? a.misfit < b.misfit : a.followed;
           });
}

// Whether any stem was followed better than the best valve so far, which the same
// observer keeps in step; loads move both alike.
template <class Real>
bool ValveSearch<Real>::promises() const {
  const Real misfit = tracker_.misfit();
  const Real tracked = tracked_[0].misfit;
  return tracked_[0].followed && tracked * tracked < Real(kPromising) * misfit * misfit;
}

template <class Real>
void ValveSearch<Real>::follow_at_length() {
  pass_.use(first_used_);
  if (index_ == at_length()) {
    index_ = 0;
    return depart();
  }
  tracker_.resume(tracked_[index_], false);
  follow(kTrackRounds, Real(kTrackSpread), Stage::kFollowed);
}

// The best ones in turn, every other time to move as they did not before; then those that
// were followed at length are placed.
template <class Real>
void ValveSearch<Real>::depart() {
  sort_tracked();
  if (index_ == kDepartures || settled()) {
    placed_ = at_length();
    beam_size_ = std::min(beam_size_, kKept);
    return place(0, Stage::kPlaced);
  }
  State state = tracked_[(beam_size_ + index_) % std::min(beam_size_, kLeft)];
  if (index_ / kLeft % 2 == 1) {
    SlipMotion& motion = state.model.friction.motion;
    motion = motion == SlipMotion::kStops ? SlipMotion::kResticks : SlipMotion::kStops;
  }
  tracker_.resume(state, true);
  follow(kTrackRounds, Real(kTrackSpread), Stage::kDeparted);
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

#define STICKBAND_INSTANTIATE(Real)               \
  template void ValveSearch<Real>::track();       \
  template bool ValveSearch<Real>::follow_next(); \
  template void ValveSearch<Real>::sift();
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)

}  // namespace ident
