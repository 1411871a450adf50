#include "ident/valve/valve_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ident/base/configurations.hpp"
#include "ident/base/elementary.hpp"
#include "ident/valve/valve_grid.hpp"

namespace ident {
namespace {

constexpr double kFirstCycles = 2;  // that a valve with a memory is fitted to
// Log-likelihood in nats by which a linear valve may be behind and still be as good.
constexpr double kAsGood = 6;
// Equation (T8): squared error of a linear valve over that of another, no better in
// practice.
constexpr double kNoBetter = 1.1;
// Random jumps of a polish near the best valve so far, as a share of the swing of u.
constexpr double kNearbyJumps = 0.04;
// (T7) Squared error of the earlier valve, over what it left before, up to which it does.
constexpr double kAsBefore = 1.3;

}  // namespace

template <class Real>
void ValveSearch<Real>::start(const SearchWindow<Real>& window, std::span<Real> x,
                              std::span<Real> scratch, Stems& stems,
                              const EarlierValve* earlier, Real u_range, bool doubted) {
  pass_.start(window, x, scratch);
  x_ = x;
  stems_ = &stems;
  scratch_ = scratch;
  best_ = {};
  earlier_ = earlier;
  u_range_ = u_range;
  doubted_ = doubted;
  searched_ = true;
  polish_ = {};
  asked_ = begins_ = taking_ = measuring_ = false;
  constexpr Real kShares[kTimeConstants - 2] = {
      Real(0.01), Real(0.03), Real(0.08), Real(0.2), Real(0.5), Real(1.3), Real(4)};
  time_constants_[0] = {};
  for (int i = 0; i < kTimeConstants - 2; ++i) {
    time_constants_[i + 1] = {pole_of(window.period * kShares[i]), Real(0)};
  }
  time_constants_[kTimeConstants - 1] = {Real(1), Real(0)};
  start_motion(SlipMotion::kSlides);
}

template <class Real>
void ValveSearch<Real>::start_motion(SlipMotion motion) {
  motion_ = motion;
  beam_ = {};
  beam_size_ = 0;
  index_ = 0;
  time_constant_ = kNoTimeConstantYet;
  sifted_ = nearby_ = false;
  round_ = 0;
  placed_ = 0;
  stage_ = Stage::kScreen;
  pass_.use(whole());
  if (motion_ != SlipMotion::kSlides) {
    const Real cycles = std::max(window().period * Real(kFirstCycles), Real(60));
    pass_.use(std::min(whole(),
                       std::max(static_cast<std::size_t>(cycles), window().first_part)));
  }
}

// Whether the pass was begun for the present stage and is over: its model is the answer.
template <class Real>
bool ValveSearch<Real>::answered() {
  return std::exchange(asked_, false);
}

// One valve after the other: its positions, then the time constants behind them.
template <class Real>
void ValveSearch<Real>::screen_next() {
  const bool slides = motion_ == SlipMotion::kSlides;
  // Where there are many candidates, neighbours share the time constants between them.
  const int stride = motion_ == SlipMotion::kResticks ? 2 : 1;
  if (time_constant_ == kNoTimeConstantYet) {
    form_ = ValveForm::kMixed;
    ValveModel<Real> model;
    const bool more = slides
                          ? sliding_start(index_, window().swing, form_, model.friction)
                          : remembering_start(index_, motion_, window().swing,
                                              window().u[0], model.friction, model.start);
    if (more) {
      model.start_known = !slides;
      time_constant_ = index_ % stride;
      pass_.place(model);
      return;
    }
    index_ = 0;
    if (slides) {
      stage_ = Stage::kPolish;
      next_polish();
    } else {
      stage_ = Stage::kGrow;
      prune_beam(kBeam);
      begin_polish(ValveForm::kMixed, beam_[0]);
    }
    return;
  }
  if (!answered()) {
    pass_.screen(time_constants_[time_constant_]);
    asked_ = true;
    return;
  }
  take_screened();
  time_constant_ += stride;
  if (time_constant_ >= kTimeConstants) {
    time_constant_ = kNoTimeConstantYet;
    ++index_;
  }
}

template <class Real>
void ValveSearch<Real>::take_screened() {
  const ValveModel<Real>& model = pass_.model();
  if (motion_ != SlipMotion::kSlides) {
    keep_in_beam(time_constant_, model);
    return;
  }
  const bool integrating = !(model.poles.slow < Real(1));
  ValveModel<Real>& kept =
      beam_[static_cast<int>(form_) + (integrating ? kValveForms : 0)];
  if (!kept.known || model.fit.error < kept.fit.error) {
    kept = model;
  }
}

template <class Real>
void ValveSearch<Real>::begin_polish(ValveForm form, const ValveModel<Real>& from,
                                     Real jumps) {
  form_ = form;
  jumps_ = jumps;
  begins_ = true;
  pass_.fit(from, true);
}

// Takes an evaluation of the present polish and begins the next; true when there is none.
template <class Real>
bool ValveSearch<Real>::polish_once() {
  if (std::exchange(begins_, false)) {
    polish_.start(form_, pass_.model(), window(), ValvePolish<Real>::kEvaluations,
                  jumps_);
  } else {
    polish_.report(pass_.model());
  }
  if (polish_.done()) {
    return true;
  }
  pass_.fit_next(polish_.propose());
  return false;
}

// Takes a model of the whole window if it is the best of its form, with the error of its
// simulation: what least squares leaves is a difference of large sums, and wrong in
// single precision where columns are nearly alike.
template <class Real>
void ValveSearch<Real>::begin_take() {
  pass_.simulate(polish_.best());
  taking_ = true;
}

template <class Real>
void ValveSearch<Real>::take() {
  taking_ = false;
  const ValveModel<Real>& model = pass_.model();
  ValveModel<Real>& kept = best_[static_cast<int>(form_)];
  if (!kept.known || model.fit.error < kept.fit.error) {
    kept = model;
  }
}

// Goes on with the present polish; true once what came of it has been taken.
template <class Real>
bool ValveSearch<Real>::take_polished() {
  if (taking_) {
    take();
    return true;
  }
  if (polish_once()) {
    begin_take();
  }
  return false;
}

// Simpler forms from what a mixed valve became.
template <class Real>
bool ValveSearch<Real>::simpler_job(int job, ValveForm& form,
                                    ValveFriction<Real>& friction) {
  switch (job) {
    case 0:
      form = ValveForm::kSymmetric;
      friction.slip_ascending = friction.slip_descending =
          (friction.slip_ascending + friction.slip_descending) / Real(2);
      return true;
    case 1:
      form = ValveForm::kAscending;
      friction.slip_ascending += friction.deadband;
      friction.deadband = friction.slip_descending = Real(0);
      return true;
    case 2:
      form = ValveForm::kDescending;
      friction.slip_descending += friction.deadband;
      friction.deadband = friction.slip_ascending = Real(0);
      return true;
    default:
      return false;
  }
}

// Sliding valves: each form from its own screening, the mixed valve from what the simpler
// ones became, and these from that one.
template <class Real>
bool ValveSearch<Real>::slide_job(int job, ValveForm& form,
                                  ValveModel<Real>& from) const {
  if (job < 2 * kValveForms) {
    form = static_cast<ValveForm>(job % kValveForms);
    from = beam_[job];
    return true;
  }
  form = ValveForm::kMixed;
  switch (job - 2 * kValveForms) {
    case 0:
      from = best(ValveForm::kSymmetric);
      return true;
    case 1:
      from = best(ValveForm::kAscending);
      return true;
    case 2:
      from = best(ValveForm::kDescending);
      return true;
    case 3:
      form = ValveForm::kSymmetric;
      from = best(ValveForm::kBacklash);
      from.friction.slip_ascending = from.friction.slip_descending =
          Real(0.3) * from.friction.deadband;
      from.friction.deadband -= from.friction.slip_ascending;
      return true;
    default:
      from = best(ValveForm::kMixed);
      return simpler_job(job - 2 * kValveForms - 4, form, from.friction);
  }
}

// Begins the next polish on the whole window, or what follows the last.
template <class Real>
void ValveSearch<Real>::next_polish() {
  pass_.use(whole());
  const bool slides = motion_ == SlipMotion::kSlides;
  ValveForm form;
  ValveModel<Real> from;
  while (slides ? slide_job(index_, form, from) : memory_job(index_, form, from)) {
    ++index_;
    if (from.known) {
      jumps_ = nearby_  ? Real(kNearbyJumps)
               : slides ? Real(ValvePolish<Real>::kFarJumps)
                        : Real(ValvePolish<Real>::kGrownJumps);
      begin_job(form, from);
      return;
    }
  }
  if (slides && doubted_ && !trusts() &&
      best(ValveForm::kLinear).fit.error < Real(kNoBetter) * best_of_all().fit.error) {
    end();
  } else if (slides) {
    stage_ = Stage::kLook;
  } else if (!nearby_) {
    search_nearby(SlipMotion::kStops);
  } else if (motion_ == SlipMotion::kStops) {
    search_nearby(SlipMotion::kResticks);
  } else {
    end();
  }
}

template <class Real>
const ValveModel<Real>& ValveSearch<Real>::best_of_all() const {
  const ValveModel<Real>* best = &best_[0];
  for (const ValveModel<Real>& model : best_) {
    if (model.known && (!best->known || model.fit.error < best->fit.error)) {
      best = &model;
    }
  }
  return *best;
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

// The next way to move. Where a valve so far leaves nothing to explain, another can only
// be like it, and none is needed beside a linear one.
template <class Real>
void ValveSearch<Real>::look() {
  if (!answered()) {
    pass_.explain(best_of_all());
    asked_ = true;
    return;
  }
  const bool explained = pass_.structure() < Real(kWhiteResidual);
  if (explained && linear_does()) {
    end();
    return;
  }
  if (explained) {
    search_nearby(SlipMotion::kStops);
  } else if (trusts()) {
    begin_earlier();
  } else {
    start_motion(SlipMotion::kStops);
  }
}

// An earlier valve that is not trusted must not lead the search: it is tried at last.
template <class Real>
void ValveSearch<Real>::end() {
  if (earlier_ != nullptr && earlier_->known()) {
    begin_earlier();
  } else {
    stage_ = Stage::kDone;
  }
}

template <class Real>
ValveModel<Real> ValveSearch<Real>::earlier_here() const {
  return start_from(*earlier_, u_range_, window().decimation, whole());
}

// The valve of an earlier window, its stem placed anew.
template <class Real>
void ValveSearch<Real>::begin_earlier() {
  pass_.use(whole());
  State& like = tracked_[0];
  like.model = earlier_here();
  like.start = resting_range(like.model.friction, window().u[0]).at(Real(0.5));
  round_ = 0;
  placing_ = true;
  stage_ = Stage::kEarlier;
}

template <class Real>
void ValveSearch<Real>::try_earlier() {
  if (placing_) {
    if (place(0, tried_)) {
      placing_ = false;
      begin_polish(ValveForm::kMixed, tried_, Real(kNearbyJumps));
    }
    return;
  }
  if (!take_polished()) {
    return;
  }
  const bool trusted = trusts();
  const Real before = earlier_here().fit.error;
  earlier_ = nullptr;
  if (!trusted) {
    end();
    return;
  }
  const Real error = pass_.model().fit.error;
  const bool as_before = error < Real(kAsBefore) * before &&
                         error < Real(kPromising) * best(ValveForm::kLinear).fit.error;
  searched_ = !as_before;
  if (searched_) {
    start_motion(SlipMotion::kStops);
  } else {
    search_nearby(SlipMotion::kStops);
  }
}

// From the best valve so far to one that moves otherwise, instead of searching for it.
template <class Real>
void ValveSearch<Real>::search_nearby(SlipMotion motion) {
  motion_ = motion;
  pass_.use(whole());
  if (linear_does()) {
    end();
    return;
  }
  const ValveModel<Real>& best = best_of_all();
  State& like = tracked_[0];
  like.start = pass_.valve_at_start(best).step(window().u[0]);
  like.model = best;
  like.model.friction.motion = motion_;
  round_ = 0;
  nearby_ = placing_ = true;
  stage_ = Stage::kTry;
}

// What follows from the pass that is over.
template <class Real>
void ValveSearch<Real>::decide() {
  switch (stage_) {
    case Stage::kScreen:
      screen_next();
      break;
    case Stage::kTrack:
      if constexpr (kSlipTracker) {
        track_next();
      }
      break;
    case Stage::kSift:
      if constexpr (kSlipTracker) {
        sift();
      }
      break;
    case Stage::kTry:
      try_next();
      break;
    case Stage::kPlace:
      if constexpr (kSlipTracker) {
        place_next();
      }
      break;
    case Stage::kGrow:
      grow_next();
      break;
    case Stage::kCompare:
      compare_beam();
      break;
    case Stage::kPolish:
      if (placing_) {
        place_one_sided();
      } else if (take_polished()) {
        next_polish();
      }
      break;
    case Stage::kLook:
      look();
      break;
    case Stage::kEarlier:
      try_earlier();
      break;
    case Stage::kDone:
      break;
  }
}

// The smallest piece of work; returns its cost.
template <class Real>
int ValveSearch<Real>::piece() {
  constexpr int kCostOfDecision = 1;
  if (!pass_.done()) {
    return pass_.step();
  }
  const bool tracking = (stage_ == Stage::kTrack && !asked_) || measuring_;
  decide();
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
                                         Real, bool);                                  \
  template bool ValveSearch<Real>::step(int);                                          \
  template void ValveSearch<Real>::start_motion(SlipMotion);                           \
  template bool ValveSearch<Real>::answered();                                         \
  template void ValveSearch<Real>::begin_polish(ValveForm, const ValveModel<Real>&,    \
                                                Real);                                 \
  template bool ValveSearch<Real>::polish_once();                                      \
  template bool ValveSearch<Real>::take_polished();                                    \
  template bool ValveSearch<Real>::simpler_job(int, ValveForm&, ValveFriction<Real>&); \
  template void ValveSearch<Real>::next_polish();                                      \
  template const ValveModel<Real>& ValveSearch<Real>::best_of_all() const;             \
  template void ValveSearch<Real>::search_nearby(SlipMotion);
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)
#undef STICKBAND_INSTANTIATE

}  // namespace ident
