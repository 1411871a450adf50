#include "ident/valve_search.hpp"

#include <algorithm>
#include <cmath>

namespace ident {
namespace {

constexpr int kPolishEvaluations = 150;

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

int free_parameters(ValveForm form) {
  switch (form) {
    case ValveForm::kLinear: return 0;
    case ValveForm::kBacklash:
    case ValveForm::kAscending:
    case ValveForm::kDescending: return 1;
    case ValveForm::kSymmetric: return 2;
    case ValveForm::kMixed: return 3;
  }
  return 0;
}

template <class Real>
void ValveSearch<Real>::start(const SearchWindow<Real>& window, std::span<Real> x) {
  window_ = window;
  x_ = x.first(window.y.size());
  best_ = {};
  screened_ = {};
  time_constants_[0] = {};
  const Real shares[kTimeConstants - 2] = {Real(0.01), Real(0.03), Real(0.08), Real(0.2),
                                           Real(0.5),  Real(1.3),  Real(4)};
  for (int i = 0; i < kTimeConstants - 2; ++i) {
    time_constants_[i + 1] = {pole_of(window.period * shares[i]), Real(0)};
  }
  time_constants_[kTimeConstants - 1] = {Real(1), Real(0)};
  stage_ = Stage::kScreen;
  index_ = 0;
}

template <class Real>
void ValveSearch<Real>::position(const ValveModel<Real>& model) {
  const ValveFriction<Real>& friction = model.friction;
  StickSlipValve<Real> valve(friction, model.start_known ? model.start : window_.u[0]);
  const bool linear = !(friction.stick_ascending() > Real(0)) &&
                      !(friction.stick_descending() > Real(0));
  // Where the stem stood before the window is not known: one cycle earlier is taken to
  // have been like the first one.
  if (!linear && !model.start_known) {
    for (std::size_t t = 0; t < window_.warm_up; ++t) {
      valve.step(window_.u[t]);
    }
  }
  const Real share = Real(1) / static_cast<Real>(window_.decimation);
  std::size_t t = 0;
  for (Real& mean : x_) {
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
  const int first = all_delays ? shortest : std::max(model.fit.delay - 3, shortest);
  const int last = all_delays ? longest : std::min(model.fit.delay + 3, longest);
  model.fit = regression_.fit(x_, window_.y, model.poles, first, last, window_.drift);
  model.known = true;
  return model;
}

// Candidates: the linear valve; sliding valves with a stick band on a grid that is finer
// where it is small; resticking valves on a finer, geometric grid.
template <class Real>
bool ValveSearch<Real>::screen_candidate(int index, ValveForm& form,
                                         ValveFriction<Real>& friction) const {
  constexpr int kSlideKinds = 3 + 3;    // backlash, one-sided, J/S = ⅓, ⅔, 1
  constexpr int kRestickKinds = 2 * (2 + 2);  // two motions; one-sided, J/S = ½, 1
  friction = {};
  if (index == 0) {
    form = ValveForm::kLinear;
    return true;
  }
  --index;
  const bool slides = index < kSlideSteps * kSlideKinds;
  Real stick;
  Real slip_share;
  int kind;
  if (slides) {
    const Real share = static_cast<Real>(index / kSlideKinds + 1) / Real(kSlideSteps);
    stick = window_.swing * Real(1.15) * share * (Real(0.4) + Real(0.6) * share);
    kind = index % kSlideKinds;
    slip_share = static_cast<Real>(kind - 2) / Real(3);
  } else {
    index -= kSlideSteps * kSlideKinds;
    if (index >= kRestickSteps * kRestickKinds) {
      return false;
    }
    stick = window_.swing * Real(0.05) *
            std::pow(Real(1.06), static_cast<Real>(index / kRestickKinds));
    kind = index % (kRestickKinds / 2) + 1;
    slip_share = static_cast<Real>(kind - 2) / Real(2);
    friction.motion = index % kRestickKinds < kRestickKinds / 2 ? SlipMotion::kResticks
                                                                : SlipMotion::kStops;
  }
  switch (kind) {
    case 0:
      form = ValveForm::kBacklash;
      friction.deadband = stick;
      break;
    case 1:
      form = ValveForm::kAscending;
      friction.slip_ascending = stick;
      break;
    case 2:
      form = ValveForm::kDescending;
      friction.slip_descending = stick;
      break;
    default:
      form = ValveForm::kSymmetric;
      friction.slip_ascending = friction.slip_descending = stick * slip_share;
      friction.deadband = stick - friction.slip_ascending;
  }
  return true;
}

// Keeps the best few, no two of nearly the same stick band.
template <class Real>
void ValveSearch<Real>::keep(ValveForm form, const ValveModel<Real>& model) {
  auto& list = screened_[static_cast<int>(form)][static_cast<int>(model.friction.motion)];
  const auto stick = [](const ValveModel<Real>& m) {
    return std::max(m.friction.stick_ascending(), m.friction.stick_descending());
  };
  ValveModel<Real> carried = model;
  for (ValveModel<Real>& slot : list) {
    if (!slot.known) {
      slot = carried;
      return;
    }
    const bool alike = std::abs(stick(slot) - stick(carried)) < Real(0.1) * stick(slot);
    if (carried.fit.error < slot.fit.error) {
      std::swap(slot, carried);
    }
    if (alike) {
      return;
    }
  }
}

template <class Real>
void ValveSearch<Real>::screen_next() {
  ValveForm form;
  ValveModel<Real> model;
  if (!screen_candidate(index_, form, model.friction)) {
    index_ = 0;
    if (!next_polish()) {
      stage_ = Stage::kDone;
    }
    return;
  }
  ++index_;
  position(model);
  ValveModel<Real> best;
  for (const ProcessPoles<Real>& poles : time_constants_) {
    const ProcessFit<Real> fit = regression_.screen(x_, window_.y, poles);
    if (!best.known || fit.error < best.fit.error) {
      best = model;
      best.known = true;
      best.poles = poles;
      best.fit = fit;
    }
  }
  keep(form, best);
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
  model.poles = {slow < window_.period * kIntegratorPeriods<Real> ? pole_of(slow) : Real(1),
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
void ValveSearch<Real>::begin_polish(ValveForm form, const ValveModel<Real>& from) {
  form_ = form;
  trial_best_ = evaluate(from, true);
  if (from.friction.motion != SlipMotion::kSlides && form != ValveForm::kLinear) {
    scan_from_ = trial_best_;
    scan_ = 0;
    stage_ = Stage::kScan;
  } else {
    begin_pattern();
  }
}

template <class Real>
void ValveSearch<Real>::scan_next() {
  if (scan_ >= kScanStarts * kScanSlips) {
    begin_pattern();
    return;
  }
  ValveModel<Real> model = scan_from_;
  ValveFriction<Real>& friction = model.friction;
  const Real scale = Real(1) + Real(0.025) * static_cast<Real>(scan_ % kScanSlips - 2);
  friction.slip_ascending *= scale;
  friction.slip_descending *= scale;
  const Real share = (static_cast<Real>(scan_ / kScanSlips) + Real(0.5)) / Real(kScanStarts);
  const Real half = friction.deadband / Real(2);
  const Real lowest = window_.u[0] - half - friction.slip_ascending;
  const Real highest = window_.u[0] + half + friction.slip_descending;
  model.start_known = true;
  model.start = lowest + share * (highest - lowest);
  ++scan_;
  model = evaluate(model, false);
  if (model.fit.error < trial_best_.fit.error) {
    trial_best_ = model;
  }
}

template <class Real>
void ValveSearch<Real>::begin_pattern() {
  stage_ = Stage::kPolish;
  const Real valve_step = window_.swing * Real(0.04);
  const Real valve_least = window_.swing * Real(0.0015);
  const Real time_step = Real(0.5);
  const Real time_least = Real(0.03);
  pattern_.start(to_point(trial_best_), trial_best_.fit.error, kPolishEvaluations);
  const auto direction = [&](Real deadband, Real ascending, Real descending) {
    pattern_.add_direction({deadband, ascending, descending, 0, 0, 0}, valve_step,
                           valve_least);
  };
  switch (form_) {
    case ValveForm::kLinear: break;
    case ValveForm::kBacklash: direction(1, 0, 0); break;
    case ValveForm::kAscending: direction(0, 1, 0); break;
    case ValveForm::kDescending: direction(0, 0, 1); break;
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
  pattern_.add_direction({0, 0, 0, 1, 0, 0}, time_step, time_least);
  pattern_.add_direction({0, 0, 0, 0, 1, 0}, Real(2) * time_step, time_least);
}

// Jobs, in order: each form from its own screening; then the mixed valve from what the
// simpler ones became.
template <class Real>
bool ValveSearch<Real>::job_start(int job, ValveForm& form, ValveModel<Real>& from) const {
  constexpr int kOwn = (kValveForms - 1) * kSlipMotions * kKept;
  if (job < kOwn) {
    form = static_cast<ValveForm>(job / (kSlipMotions * kKept));
    const int rank = job % kKept;
    // One start is enough where there is one parameter or none, and little memory.
    if (rank > 0 && form != ValveForm::kSymmetric) {
      return false;
    }
    from = screened_[job / (kSlipMotions * kKept)][job / kKept % kSlipMotions][rank];
    return from.known;
  }
  form = ValveForm::kMixed;
  switch (job - kOwn) {
    case 0: from = best(ValveForm::kSymmetric); break;
    case 1: from = best(ValveForm::kAscending); break;
    case 2: from = best(ValveForm::kDescending); break;
    case 3:
      from = best(ValveForm::kBacklash);
      from.friction.slip_ascending = Real(0.3) * from.friction.deadband;
      from.friction.deadband -= from.friction.slip_ascending;
      break;
    case 4:
      from = best(ValveForm::kSymmetric);
      from.friction.slip_ascending *= Real(0.5);
      from.friction.slip_descending *= Real(1.3);
      break;
    case 5:
      from = best(ValveForm::kSymmetric);
      from.friction.slip_ascending *= Real(1.3);
      from.friction.slip_descending *= Real(0.5);
      break;
    default: from = {};
  }
  return from.known;
}

template <class Real>
bool ValveSearch<Real>::next_polish() {
  constexpr int kJobs = (kValveForms - 1) * kSlipMotions * kKept + 6;
  while (index_ < kJobs) {
    ValveForm form;
    ValveModel<Real> from;
    if (job_start(index_++, form, from)) {
      begin_polish(form, from);
      return true;
    }
  }
  return false;
}

template <class Real>
void ValveSearch<Real>::polish_next() {
  if (!pattern_.done()) {
    Point point = pattern_.propose();
    clamp(point);
    const ValveModel<Real> model = evaluate(model_at(point), false);
    if (pattern_.report(point, model.fit.error)) {
      trial_best_ = model;
    }
    return;
  }
  ValveModel<Real>& kept = best_[static_cast<int>(form_)];
  if (!kept.known || trial_best_.fit.error < kept.fit.error) {
    kept = trial_best_;
  }
  if (!next_polish()) {
    stage_ = Stage::kDone;
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
      case Stage::kScan:
        scan_next();
        ++used;
        break;
      case Stage::kPolish:
        polish_next();
        ++used;
        break;
      case Stage::kDone: break;
    }
  }
  return done();
}

template class ValveSearch<float>;
template class ValveSearch<double>;

}  // namespace ident
