#include "ident/valve_search.hpp"

#include <algorithm>
#include <cmath>

#include "ident/configurations.hpp"
#include "ident/residual_structure.hpp"
#include "ident/valve_grid.hpp"

namespace ident {
namespace {

constexpr double kFirstCycles = 2;  // that a valve with a memory is fitted to
// Structure of a residual that leaves nothing to explain.
constexpr double kWhite = 2;
// Log-likelihood in nats by which a linear valve may be behind and still be as good.
constexpr double kAsGood = 6;

template <class Real>
bool is_linear(const ValveFriction<Real>& friction) {
  return !(friction.stick_ascending() > Real(0)) &&
         !(friction.stick_descending() > Real(0));
}

}  // namespace

template <class Real>
void ValveSearch<Real>::start(const SearchWindow<Real>& window, std::span<Real> x,
                              std::span<Real> scratch) {
  window_ = window;
  scratch_ = scratch;
  x_ = x.first(window.y.size());
  best_ = {};
  screened_ = {};
  polish_ = {};
  constexpr Real kShares[kTimeConstants - 2] = {
      Real(0.01), Real(0.03), Real(0.08), Real(0.2), Real(0.5), Real(1.3), Real(4)};
  time_constants_[0] = {};
  for (int i = 0; i < kTimeConstants - 2; ++i) {
    time_constants_[i + 1] = {pole_of(window.period * kShares[i]), Real(0)};
  }
  time_constants_[kTimeConstants - 1] = {Real(1), Real(0)};
  motion_ = SlipMotion::kSlides;
  start_motion();
}

template <class Real>
void ValveSearch<Real>::start_motion() {
  beam_ = {};
  beam_size_ = 0;
  index_ = 0;
  time_constant_ = kNoTimeConstantYet;
  sifted_ = nearby_ = false;
  round_ = 0;
  placed_ = 0;
  stage_ = Stage::kScreen;
  active_ = window_.y.size();
  if (motion_ != SlipMotion::kSlides) {
    const Real cycles = std::max(window_.period * Real(kFirstCycles), Real(60));
    active_ =
        std::min(active_, std::max(static_cast<std::size_t>(cycles), window_.first_part));
  }
}

template <class Real>
StickSlipValve<Real> ValveSearch<Real>::valve_at_start(
    const ValveModel<Real>& model) const {
  const ValveFriction<Real>& friction = model.friction;
  // Where the stem stood before the window is not known. At the highest u of the first
  // cycle a valve that moves at all trails by half the deadband; the rest of that cycle
  // leads to the state at its start.
  Real start = model.start_known ? model.start : window_.u[0];
  std::size_t top = window_.warm_up;
  if (!model.start_known && window_.warm_up > 0) {
    const auto cycle = window_.u.first(window_.warm_up);
    top = static_cast<std::size_t>(std::max_element(cycle.begin(), cycle.end()) -
                                   cycle.begin());
    start = cycle[top] - friction.deadband / Real(2);
  }
  StickSlipValve<Real> valve(friction, start);
  for (std::size_t t = top; t < window_.warm_up; ++t) {
    valve.step(window_.u[t]);
  }
  return valve;
}

template <class Real>
void ValveSearch<Real>::position(const ValveModel<Real>& model) {
  const bool linear = is_linear(model.friction);
  StickSlipValve<Real> valve =
      linear ? StickSlipValve<Real>(model.friction, Real(0)) : valve_at_start(model);
  const Real share = Real(1) / static_cast<Real>(window_.decimation);
  std::size_t t = 0;
  for (Real& mean : x_.first(active_)) {
    Real sum = 0;
    for (int k = 0; k < window_.decimation; ++k, ++t) {
      sum += linear ? window_.u[t] : valve.step(window_.u[t]);
    }
    mean = sum * share;
  }
}

template <class Real>
std::span<const Real> ValveSearch<Real>::simulate(const ValveModel<Real>& model) {
  const std::span<Real> simulated = scratch_.first(active_);
  position(model);
  regression_.simulate(x_.first(active_), model.poles, model.fit, simulated);
  return simulated;
}

template <class Real>
ValveModel<Real> ValveSearch<Real>::evaluate(ValveModel<Real> model, bool all_delays) {
  position(model);
  const DelayRange delays =
      all_delays ? every_delay(window_) : delays_near(window_, model.fit.delay);
  model.fit = regression_.fit(x_.first(active_), window_.y.first(active_), model.poles,
                              delays.first, delays.last, window_.drift);
  model.known = true;
  return model;
}

template <class Real>
bool ValveSearch<Real>::alike(const ValveModel<Real>& a,
                              const ValveModel<Real>& b) const {
  const Real width = Real(0.04) * window_.swing;
  const auto near = [&](Real one, Real other) { return std::abs(one - other) < width; };
  return near(a.friction.stick_ascending(), b.friction.stick_ascending()) &&
         near(a.friction.stick_descending(), b.friction.stick_descending()) &&
         near(a.friction.deadband, b.friction.deadband);
}

template <class Real>
void ValveSearch<Real>::screen_next() {
  ValveForm form = ValveForm::kMixed;
  ValveModel<Real> model;
  const bool slides = motion_ == SlipMotion::kSlides;
  const bool more = slides ? sliding_start(index_, window_.swing, form, model.friction)
                           : remembering_start(index_, motion_, window_.swing,
                                               window_.u[0], model.friction, model.start);
  model.start_known = !slides;
  if (!more) {
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
  // Where there are many candidates, neighbours share the time constants between them.
  const int stride = motion_ == SlipMotion::kResticks ? 2 : 1;
  if (time_constant_ < 0) {
    position(model);
    time_constant_ = index_ % stride;
  }
  const int k = time_constant_;
  time_constant_ += stride;
  if (time_constant_ >= kTimeConstants) {
    time_constant_ = kNoTimeConstantYet;
    ++index_;
  }
  model.poles = time_constants_[k];
  model.fit =
      regression_.screen(x_.first(active_), window_.y.first(active_), model.poles);
  model.known = true;
  if (!slides) {
    keep_in_beam(k, model);
    return;
  }
  const bool integrating = !(model.poles.slow < Real(1));
  ValveModel<Real>& kept =
      screened_[static_cast<int>(form) + (integrating ? kValveForms : 0)];
  if (!kept.known || model.fit.error < kept.fit.error) {
    kept = model;
  }
}

template <class Real>
void ValveSearch<Real>::begin_polish(ValveForm form, const ValveModel<Real>& from,
                                     double jumps) {
  form_ = form;
  polish_.start(form, evaluate(from, true), window_, ValvePolish<Real>::kEvaluations,
                jumps);
}

// One evaluation of the present polish; true when it is over.
template <class Real>
bool ValveSearch<Real>::polish_once() {
  if (polish_.done()) {
    return true;
  }
  polish_.report(evaluate(polish_.propose(), false));
  return false;
}

// Takes a model of the whole window if it is the best of its form, with the error of its
// simulation: what least squares leaves is a difference of large sums, and wrong in
// single precision where columns are nearly alike.
template <class Real>
void ValveSearch<Real>::take(ValveForm form, ValveModel<Real> model) {
  const std::span<const Real> simulated = simulate(model);
  model.fit.error = 0;
  for (std::size_t t = 0; t < simulated.size(); ++t) {
    const Real e = window_.y[t] - simulated[t];
    model.fit.error += e * e;
  }
  ValveModel<Real>& kept = best_[static_cast<int>(form)];
  if (!kept.known || model.fit.error < kept.fit.error) {
    kept = model;
  }
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
    from = screened_[job];
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
  active_ = window_.y.size();
  const bool slides = motion_ == SlipMotion::kSlides;
  ValveForm form;
  ValveModel<Real> from;
  while (slides ? slide_job(index_, form, from) : memory_job(index_, form, from)) {
    ++index_;
    if (from.known) {
      begin_polish(form, from, nearby_ ? 0.04 : ValvePolish<Real>::kFarJumps);
      return;
    }
  }
  if (motion_ != SlipMotion::kResticks) {
    stage_ = Stage::kLook;
  } else if (nearby_) {
    stage_ = Stage::kDone;
  } else {
    search_nearby();
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

// Whether nothing is left that another valve could explain.
template <class Real>
bool ValveSearch<Real>::explains(const ValveModel<Real>& model) {
  return residual_structure<Real>(window_.y.first(active_), simulate(model)) <
         Real(kWhite);
}

// Whether a linear valve is as good as any so far.
template <class Real>
bool ValveSearch<Real>::linear_does() const {
  const Real samples = static_cast<Real>(window_.y.size());
  return samples / Real(2) *
             std::log(best(ValveForm::kLinear).fit.error / best_of_all().fit.error) <
         Real(kAsGood);
}

// The next way to move. Where a valve so far leaves nothing to explain, another can only
// be like it, and none is needed beside a linear one.
template <class Real>
void ValveSearch<Real>::look() {
  const bool explained = explains(best_of_all());
  if (explained && linear_does()) {
    stage_ = Stage::kDone;
    return;
  }
  motion_ = motion_ == SlipMotion::kSlides ? SlipMotion::kStops : SlipMotion::kResticks;
  start_motion();
  if (explained) {
    search_nearby();
  }
}

// From the best valve so far to one that moves otherwise, instead of searching for it.
template <class Real>
void ValveSearch<Real>::search_nearby() {
  active_ = window_.y.size();
  if (linear_does()) {
    stage_ = motion_ == SlipMotion::kResticks ? Stage::kDone : Stage::kLook;
    return;
  }
  const ValveModel<Real>& best = best_of_all();
  State& like = tracked_[0];
  like.start = valve_at_start(best).step(window_.u[0]);
  like.model = best;
  like.model.friction.motion = motion_;
  round_ = 0;
  nearby_ = placing_ = true;
  stage_ = Stage::kTry;
}

template <class Real>
int ValveSearch<Real>::cost_of_pass() const {
  constexpr int kPerMean = 200;
  constexpr int kPerSample = 33;
  return static_cast<int>(active_) * (kPerMean + kPerSample * window_.decimation) / 1000 +
         1;
}

template <class Real>
int ValveSearch<Real>::cost_of_piece() const {
  constexpr int kPerScreened = 230;
  if (stage_ == Stage::kTrack) {
    return tracker_.cost_of_step();
  }
  if (stage_ == Stage::kScreen && time_constant_ != kNoTimeConstantYet) {
    return static_cast<int>(active_) * kPerScreened / 1000 + 1;
  }
  return cost_of_pass();
}

template <class Real>
bool ValveSearch<Real>::step(int budget) {
  for (int left = budget * kUnit; left > 0 && stage_ != Stage::kDone;) {
    left -= cost_of_piece();
    switch (stage_) {
      case Stage::kScreen:
        screen_next();
        break;
      case Stage::kTrack:
        track_next();
        break;
      case Stage::kSift:
        sift();
        break;
      case Stage::kTry:
        try_next();
        break;
      case Stage::kPlace:
        place_next();
        break;
      case Stage::kGrow:
        grow_next();
        break;
      case Stage::kCompare:
        compare_beam();
        break;
      case Stage::kPolish:
        if (polish_once()) {
          take(form_, polish_.best());
          next_polish();
        }
        break;
      case Stage::kLook:
        look();
        break;
      case Stage::kDone:
        break;
    }
  }
  return done();
}

template class ValveSearch<float>;
template class ValveSearch<double>;

}  // namespace ident
