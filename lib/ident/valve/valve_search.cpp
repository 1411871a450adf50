#include "ident/valve/valve_search.hpp"

#include <algorithm>

#include "ident/base/configurations.hpp"
#include "ident/base/elementary.hpp"

namespace ident {
namespace {

// Log-likelihood in nats by which a linear valve may be behind and still be as good.
constexpr double kAsGood = 6;
// Equation (T8): squared error of a linear valve over that of another, no better in
// practice.
constexpr double kNoBetter = 1.1;
// (T7) Squared error of the earlier valve, over what it left before, up to which it does.
constexpr double kAsBefore = 1.3;

}  // namespace

template <class Real>
void ValveSearch<Real>::start(const SearchWindow<Real>& window, std::span<Real> x,
                              std::span<Real> scratch, Stems& stems,
                              const EarlierValve* earlier, Real u_range, bool doubted,
                              Elsewhere* elsewhere) {
  pass_.start(window, x, scratch);
  x_ = x;
  stems_ = &stems;
  scratch_ = scratch;
  best_ = {};
  earlier_ = earlier;
  u_range_ = u_range;
  doubted_ = doubted;
  searched_ = true;
  elsewhere_ = elsewhere;
  polish_ = {};
  constexpr Real kShares[kTimeConstants - 2] = {
      Real(0.01), Real(0.03), Real(0.08), Real(0.2), Real(0.5), Real(1.3), Real(4)};
  time_constants_[0] = {};
  for (int i = 0; i < kTimeConstants - 2; ++i) {
    time_constants_[i + 1] = {pole_of(window.period * kShares[i]), Real(0)};
  }
  time_constants_[kTimeConstants - 1] = {Real(1), Real(0)};
  screen(SlipMotion::kSlides, Stage::kSlidesScreened);
}

// What follows from the trials that are over.
template <class Real>
void ValveSearch<Real>::decide() {
  constexpr Real kFar = Real(ValvePolish<Real>::kFarJumps);
  switch (stage_) {
    case Stage::kSlidesScreened:
      return polish_all(Trials::kJobs, 0, kFar, Stage::kSlidesPolished);
    case Stage::kSlidesPolished:
      if (!worth_more()) {
        return end();
      }
      pass_.explain(best_of_all());
      return begin(Trials::kOne, Stage::kExplained);
    case Stage::kExplained:
      // Where a valve leaves nothing to explain, another can only be like it.
      if (pass_.structure() < Real(kWhiteResidual)) {
        return search_nearby(SlipMotion::kStops);
      }
      return trusts() ? try_earlier()
                      : screen(SlipMotion::kStops, Stage::kRememberingScreened);
    default:
      return remember();
    case Stage::kLeftExplained:
    case Stage::kPartBegun:
    case Stage::kElsewherePlaced:
    case Stage::kElsewherePolished:
      if constexpr (kStemSearch) {
        take_elsewhere();
      }
      return;
    case Stage::kRemembered:
      return search_nearby(SlipMotion::kStops);
    case Stage::kNearbyVaried:
      return polish_tried(kFar, Stage::kNearbyPolished);
    case Stage::kNearbyPolished:
      beam_[0] = polish_.best();
      return polish_all(Trials::kJobs, kPolished, Real(kNearbyJumps),
                        Stage::kNearbySimplified);
    case Stage::kNearbySimplified:
      return motion_ == SlipMotion::kStops ? search_nearby(SlipMotion::kResticks) : end();
    case Stage::kEarlierPlaced:
      return polish_tried(Real(kNearbyJumps), Stage::kEarlierPolished);
    case Stage::kEarlierPolished: {
      const bool trusted = trusts();
      searched_ = !trusted || !does_as_before();
      earlier_ = nullptr;
      if (!trusted) {
        return end();
      }
      return searched_ ? screen(SlipMotion::kStops, Stage::kRememberingScreened)
                       : search_nearby(SlipMotion::kStops);
    }
  }
}

// From the best valve so far to one that moves otherwise, instead of searching for it;
// none is needed beside a linear one.
template <class Real>
void ValveSearch<Real>::search_nearby(SlipMotion motion) {
  motion_ = motion;
  pass_.use(whole());
  if (linear_does()) {
    return end();
  }
  const ValveModel<Real>& best = best_of_all();
  State& like = tracked_[0];
  like.start = pass_.valve_at_start(best).step(window().u[0]);
  like.model = best;
  like.model.friction.motion = motion_;
  nearby_ = true;
  begin(Trials::kNearby, Stage::kNearbyVaried);
}

// An earlier valve that is not trusted must not lead the search: it is tried at last.
template <class Real>
void ValveSearch<Real>::end() {
  if (earlier_ != nullptr && earlier_->known()) {
    return try_earlier();
  }
  stage_ = Stage::kDone;
  if constexpr (kStemSearch) {
    if (searches_part()) {
      return come_back();
    }
    if (searched_ && may_be_elsewhere()) {
      pass_.use(whole());
      pass_.explain(best_of_all());
      begin(Trials::kOne, Stage::kLeftExplained);
    }
  }
}

// The valve of an earlier window, its stem placed anew.
template <class Real>
void ValveSearch<Real>::try_earlier() {
  pass_.use(whole());
  State& like = tracked_[0];
  like.model = earlier_here();
  like.start = resting_range(like.model.friction, window().u[0]).at(Real(0.5));
  place(0, Stage::kEarlierPlaced);
}

template <class Real>
bool ValveSearch<Real>::does_as_before() const {
  const Real error = pass_.model().fit.error;
  return error < Real(kAsBefore) * earlier_here().fit.error &&
         error < Real(kPromising) * best(ValveForm::kLinear).fit.error;
}

// Whether others than valves that slide may pay.
template <class Real>
bool ValveSearch<Real>::worth_more() const {
  return !doubted_ || trusts() ||
         !(best(ValveForm::kLinear).fit.error <
           Real(kNoBetter) * best_of_all().fit.error);
}

template <class Real>
const ValveModel<Real>& ValveSearch<Real>::best_of_all() const {
  return *std::min_element(best_.begin(), best_.end(),
                           [](const auto& a, const auto& b) { return better(a, b); });
}

// Whether a linear valve is as good as any so far.
template <class Real>
bool ValveSearch<Real>::linear_does() const {
  const Real samples = static_cast<Real>(whole());
  return samples / Real(2) *
             elementary::log(best(ValveForm::kLinear).fit.error /
                             best_of_all().fit.error) <
         Real(kAsGood);
}

template <class Real>
ValveModel<Real> ValveSearch<Real>::earlier_here() const {
  return start_from(*earlier_, u_range_, window().decimation, whole());
}

// The smallest piece of work; returns its cost.
template <class Real>
int ValveSearch<Real>::piece() {
  constexpr int kCostOfDecision = 1;
  if (!pass_.done()) {
    return pass_.step();
  }
  const bool tracking = trials_ >= Trials::kRounds;
  if (next_trial()) {
    decide();
  }
  if constexpr (kSlipTracker) {
    return tracking ? tracker_.cost() : kCostOfDecision;
  }
  return kCostOfDecision;
}

template <class Real>
bool ValveSearch<Real>::step(int budget) {
  for (int left = budget * kUnit; left > 0 && stage_ != Stage::kDone;) {
    left -= piece();
  }
  return done();
}

// Member by member: of a class instantiated whole, GCC hides from link-time optimisation
// that other files have to bring the rest.
#define STICKBAND_INSTANTIATE(Real)                                                    \
  template void ValveSearch<Real>::start(const SearchWindow<Real>&, std::span<Real>,   \
                                         std::span<Real>, Stems&, const EarlierValve*, \
                                         Real, bool, Elsewhere*);                      \
  template bool ValveSearch<Real>::step(int);                                          \
  template const ValveModel<Real>& ValveSearch<Real>::best_of_all() const;             \
  template void ValveSearch<Real>::end();                                              \
  template void ValveSearch<Real>::search_nearby(SlipMotion);
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)

}  // namespace ident
