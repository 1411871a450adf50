#include "ident/valve_search.hpp"

#include <algorithm>
#include <cmath>

#include "ident/valve_grid.hpp"

namespace ident {
namespace {

// A beam of candidates is polished on the first cycles, then on more and more of them.
constexpr double kFirstStep = 0.03;  // of the polish, as a share of the swing of u
constexpr double kFirstCycles = 2;
constexpr double kGrowth = 1.6;
constexpr int kGrowEvaluations = 200;

// A time constant above this many periods cannot be told from an integrator.
template <class Real>
constexpr Real kIntegratorPeriods = Real(30);

template <class Real>
Real pole_of(Real time_constant) {
  return time_constant > Real(0.12) ? std::exp(Real(-1) / time_constant) : Real(0);
}

template <class Real>
Real time_constant_of(Real pole) {
  return pole > Real(0) ? Real(-1) / std::log(pole) : Real(0.1);
}

}  // namespace

template <class Real>
void ValveSearch<Real>::start(const SearchWindow<Real>& window, std::span<Real> x) {
  window_ = window;
  x_ = x.first(window.y.size());
  best_ = {};
  screened_ = {};
  random_ = 1;
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
  stage_ = Stage::kScreen;
  active_ = window_.y.size();
  if (motion_ != SlipMotion::kSlides) {
    const Real cycles = std::max(window_.period * Real(kFirstCycles), Real(60));
    active_ =
        std::min(active_, std::max(static_cast<std::size_t>(cycles), window_.first_part));
  }
}

template <class Real>
void ValveSearch<Real>::position(const ValveModel<Real>& model) {
  const ValveFriction<Real>& friction = model.friction;
  const bool linear =
      !(friction.stick_ascending() > Real(0)) && !(friction.stick_descending() > Real(0));
  // Where the stem stood before the window is not known. At the highest u of the first
  // cycle a valve that moves at all trails by half the deadband; the rest of that cycle
  // leads to the state at its start.
  Real start = model.start_known ? model.start : window_.u[0];
  std::size_t top = window_.warm_up;
  if (!linear && !model.start_known && window_.warm_up > 0) {
    const auto cycle = window_.u.first(window_.warm_up);
    top = static_cast<std::size_t>(std::max_element(cycle.begin(), cycle.end()) -
                                   cycle.begin());
    start = cycle[top] - friction.deadband / Real(2);
  }
  StickSlipValve<Real> valve(friction, start);
  for (std::size_t t = top; t < window_.warm_up; ++t) {
    valve.step(window_.u[t]);
  }
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
ValveModel<Real> ValveSearch<Real>::evaluate(ValveModel<Real> model, bool all_delays) {
  position(model);
  // Within a mean of several samples the newest u may already act on y.
  const int shortest = window_.decimation > 1 ? 0 : 1;
  const int longest = kDelayTaps - 2;
  const int first = all_delays ? shortest : std::max(model.fit.delay - 2, shortest);
  const int last = all_delays ? longest : std::min(model.fit.delay + 2, longest);
  model.fit = regression_.fit(x_.first(active_), window_.y.first(active_), model.poles,
                              first, last, window_.drift);
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

// The best unlike candidates of each time constant: a slow process forgives a wrong
// valve, so it must not crowd out the others before they are polished.
template <class Real>
void ValveSearch<Real>::keep_in_beam(int time_constant, const ValveModel<Real>& model) {
  ValveModel<Real>* const slots = &beam_[kPerTimeConstant * time_constant];
  ValveModel<Real> carried = model;
  for (int k = 0; k < kPerTimeConstant; ++k) {
    if (!slots[k].known) {
      slots[k] = carried;
      return;
    }
    const bool same = alike(slots[k], carried);
    if (carried.fit.error < slots[k].fit.error) {
      std::swap(slots[k], carried);
    }
    if (same) {
      return;
    }
  }
}

// Sorts the beam and keeps the best unlike members, at most `most`.
template <class Real>
void ValveSearch<Real>::prune_beam(int most) {
  std::sort(beam_.begin(), beam_.end(), [](const auto& a, const auto& b) {
    return a.known && (!b.known || a.fit.error < b.fit.error);
  });
  beam_size_ = 0;
  for (int k = 0; k < kBeam && beam_[k].known && beam_size_ < most; ++k) {
    bool fresh = true;
    for (int other = 0; other < beam_size_; ++other) {
      fresh = fresh && !(alike(beam_[other], beam_[k]) &&
                         std::abs(beam_[other].start - beam_[k].start) <
                             Real(0.04) * window_.swing);
    }
    if (fresh) {
      beam_[beam_size_++] = beam_[k];
    }
  }
  for (int k = beam_size_; k < kBeam; ++k) {
    beam_[k].known = false;
  }
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
      begin_polish(ValveForm::kMixed, beam_[0], kGrowEvaluations);
    }
    return;
  }
  // Where there are many candidates, neighbours share the time constants between them.
  const int stride = motion_ == SlipMotion::kResticks ? 2 : 1;
  const int first = index_ % stride;
  ++index_;
  position(model);
  ValveModel<Real> best;
  for (int k = first; k < kTimeConstants; k += stride) {
    model.poles = time_constants_[k];
    model.fit =
        regression_.screen(x_.first(active_), window_.y.first(active_), model.poles);
    model.known = true;
    if (!slides) {
      keep_in_beam(k, model);
    } else if (!best.known || model.fit.error < best.fit.error) {
      best = model;
    }
  }
  if (!slides) {
    return;
  }
  ValveModel<Real>& kept = screened_[static_cast<int>(form)];
  if (!kept.known || best.fit.error < kept.fit.error) {
    kept = best;
  }
}

template <class Real>
typename ValveSearch<Real>::Point ValveSearch<Real>::to_point(
    const ValveModel<Real>& model) const {
  const Real longest = window_.period * kIntegratorPeriods<Real>;
  const Real slow = model.poles.slow < Real(1)
                        ? std::min(time_constant_of(model.poles.slow), longest)
                        : longest * Real(1.01);
  return {model.friction.deadband,
          model.friction.slip_ascending,
          model.friction.slip_descending,
          std::log(slow),
          std::log(time_constant_of(model.poles.fast)),
          model.start};
}

template <class Real>
ValveModel<Real> ValveSearch<Real>::model_at(const Point& point) const {
  ValveModel<Real> model = trial_best_;
  model.friction = {point[0], point[1], point[2], trial_best_.friction.motion};
  const Real slow = std::exp(point[3]);
  model.poles = {
      slow < window_.period * kIntegratorPeriods<Real> ? pole_of(slow) : Real(1),
      pole_of(std::exp(point[4]))};
  model.start = point[5];
  return model;
}

template <class Real>
void ValveSearch<Real>::clamp(Point& point) const {
  for (int i = 0; i < 3; ++i) {
    point[i] = std::max(point[i], Real(0));
  }
  const Real shortest = std::log(Real(0.1));
  const Real longest = std::log(window_.period * kIntegratorPeriods<Real> * Real(1.02));
  point[3] = std::clamp(point[3], shortest, longest);
  point[4] = std::clamp(point[4], shortest, point[3]);
}

template <class Real>
void ValveSearch<Real>::begin_polish(ValveForm form, const ValveModel<Real>& from,
                                     int evaluations) {
  form_ = form;
  trial_best_ = evaluate(from, true);
  const Real valve_step = window_.swing * Real(kFirstStep);
  const Real valve_least = window_.swing * Real(0.0007);
  const Real time_step = Real(0.4);
  const Real time_least = Real(0.03);
  pattern_.start(to_point(trial_best_), trial_best_.fit.error, evaluations);
  const auto direction = [&](Real deadband, Real ascending, Real descending) {
    pattern_.add_direction({deadband, ascending, descending, 0, 0, 0}, valve_step,
                           valve_least);
  };
  switch (form) {
    case ValveForm::kLinear:
      break;
    case ValveForm::kBacklash:
      direction(1, 0, 0);
      break;
    case ValveForm::kAscending:
      direction(0, 1, 0);
      break;
    case ValveForm::kDescending:
      direction(0, 0, 1);
      break;
    case ValveForm::kSymmetric:
      direction(1, 0, 0);
      direction(0, 1, 1);
      direction(-1, 1, 1);
      break;
    case ValveForm::kMixed:
      direction(1, 0, 0);
      direction(0, 1, 0);
      direction(0, 0, 1);
      direction(-1, 1, 1);
      direction(0, 1, -1);
      break;
  }
  if (trial_best_.start_known) {
    pattern_.add_direction({0, 0, 0, 0, 0, 1}, valve_step, valve_least);
  }
  if (trial_best_.start_known && form == ValveForm::kMixed) {
    // Deadband against slips, the stem's start going with one stroke or the other.
    pattern_.add_direction({1, -1, -1, 0, 0, Real(0.5)}, valve_step, valve_least);
    pattern_.add_direction({1, -1, -1, 0, 0, Real(-0.5)}, valve_step, valve_least);
  }
  pattern_.add_direction({0, 0, 0, 1, 0, 0}, time_step, time_least);
  pattern_.add_direction({0, 0, 0, 0, 1, 0}, Real(2) * time_step, time_least);
}

// One evaluation of the present polish; true when it is over.
template <class Real>
bool ValveSearch<Real>::polish_once() {
  if (pattern_.done()) {
    return true;
  }
  const bool jumps = form_ == ValveForm::kMixed && pattern_.left() % 2 == 0;
  Point point = jumps ? jump() : pattern_.propose();
  clamp(point);
  const ValveModel<Real> model = evaluate(model_at(point), false);
  const bool better = jumps ? pattern_.offer(point, model.fit.error)
                            : pattern_.report(point, model.fit.error);
  if (better) {
    trial_best_ = model;
  }
  return false;
}

// Uniform in −1 … 1 (Numerical Recipes' quick generator).
template <class Real>
Real ValveSearch<Real>::uniform() {
  random_ = random_ * 1664525u + 1013904223u;
  return static_cast<Real>(random_ >> 8) / Real(1 << 23) - Real(1);
}

// A jump in all coordinates of the valve, shorter as the polish goes on: the error has
// many local minima where the valve loses step.
template <class Real>
typename ValveSearch<Real>::Point ValveSearch<Real>::jump() {
  const Real left = static_cast<Real>(pattern_.left()) / Real(kPolishEvaluations);
  const Real reach = window_.swing * (Real(0.005) + Real(0.12) * left * left);
  Point point = pattern_.best();
  for (const int k : {0, 1, 2, 5}) {
    point[k] += reach * uniform() * std::abs(uniform());
  }
  if (trial_best_.start_known) {
    // Deadband against slips is the direction in which the data say least.
    const Real trade = reach * uniform();
    point[0] += trade;
    point[1] -= trade;
    point[2] -= trade;
    point[5] += Real(0.5) * trade * (uniform() > Real(0) ? Real(1) : Real(-1));
  }
  return point;
}

template <class Real>
void ValveSearch<Real>::take(ValveForm form, const ValveModel<Real>& model) {
  ValveModel<Real>& kept = best_[static_cast<int>(form)];
  if (!kept.known || model.fit.error < kept.fit.error) {
    kept = model;
  }
}

// The beam's next member on the present cycles, or all of them on more cycles.
template <class Real>
void ValveSearch<Real>::grow_next() {
  if (!polish_once()) {
    return;
  }
  beam_[index_] = trial_best_;
  if (++index_ < beam_size_) {
    begin_polish(ValveForm::kMixed, beam_[index_], kGrowEvaluations);
    return;
  }
  start_growth_stage();
}

template <class Real>
void ValveSearch<Real>::start_growth_stage() {
  index_ = 0;
  if (active_ == window_.y.size()) {
    prune_beam(kGrown);
    stage_ = Stage::kPolish;
    next_polish();
    return;
  }
  prune_beam(std::max(kPolished, std::min(beam_size_ - 3, kGrown)));
  active_ =
      std::min(window_.y.size(),
               static_cast<std::size_t>(static_cast<Real>(active_) * Real(kGrowth)));
  begin_polish(ValveForm::kMixed, beam_[0], kGrowEvaluations);
}

// Sliding valves: each form from its own screening, then the mixed valve from what the
// simpler ones became.
template <class Real>
bool ValveSearch<Real>::slide_job(int job, ValveForm& form,
                                  ValveModel<Real>& from) const {
  if (job < kValveForms) {
    form = static_cast<ValveForm>(job);
    from = screened_[job];
    return true;
  }
  form = ValveForm::kMixed;
  switch (job - kValveForms) {
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
      return false;
  }
}

// Valves with a memory: the mixed valve from the beam, then the simpler forms from it.
template <class Real>
bool ValveSearch<Real>::memory_job(int job, ValveForm& form,
                                   ValveModel<Real>& from) const {
  if (job < kPolished) {
    form = ValveForm::kMixed;
    from = beam_[job];
    return true;
  }
  from = best(ValveForm::kMixed);
  if (from.friction.motion != motion_) {
    from = beam_[0];
  }
  ValveFriction<Real>& friction = from.friction;
  switch (job - kPolished) {
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

// Begins the next polish on the whole window, or the next motion; false at the very end.
template <class Real>
bool ValveSearch<Real>::next_polish() {
  active_ = window_.y.size();
  const bool slides = motion_ == SlipMotion::kSlides;
  ValveForm form;
  ValveModel<Real> from;
  while (slides ? slide_job(index_, form, from) : memory_job(index_, form, from)) {
    ++index_;
    if (from.known) {
      begin_polish(form, from, kPolishEvaluations);
      return true;
    }
  }
  if (motion_ == SlipMotion::kResticks) {
    stage_ = Stage::kDone;
    return false;
  }
  motion_ = slides ? SlipMotion::kStops : SlipMotion::kResticks;
  start_motion();
  return true;
}

template <class Real>
void ValveSearch<Real>::settle_errors(std::span<Real> scratch) {
  active_ = window_.y.size();
  const std::span<Real> simulated = scratch.first(active_);
  for (ValveModel<Real>& model : best_) {
    if (!model.known) {
      continue;
    }
    position(model);
    regression_.simulate(x_, model.poles, model.fit, simulated);
    model.fit.error = 0;
    for (std::size_t t = 0; t < active_; ++t) {
      const Real e = window_.y[t] - simulated[t];
      model.fit.error += e * e;
    }
  }
}

template <class Real>
bool ValveSearch<Real>::step(int evaluations) {
  for (int used = 0; used < evaluations && stage_ != Stage::kDone;) {
    switch (stage_) {
      case Stage::kScreen:
        screen_next();
        used += kTimeConstants;
        break;
      case Stage::kGrow:
        grow_next();
        ++used;
        break;
      case Stage::kPolish:
        if (polish_once()) {
          take(form_, trial_best_);
          next_polish();
        }
        ++used;
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
