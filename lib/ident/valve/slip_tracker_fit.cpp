// The part of the tracker that makes a model of the best stem's slips.
#include <algorithm>
#include <cmath>
#include <utility>

#include "ident/base/elementary.hpp"
#include "ident/valve/slip_tracker.hpp"

namespace ident {

// Equation (T3): with the gain found, the observer's error is this less the stem's
// positions through the pole pole · (1 − correction).
template <class Real>
void SlipTracker<Real>::filter_output(Real pole) {
  filtered_pole_ = pole;
  const Real kept = pole * (Real(1) - correction_);
  Real state = window_.y[0] * (Real(1) - pole) / (Real(1) - kept);
  filtered_[0] = state;
  for (std::size_t t = 1; t < used_; ++t) {
    state = kept * state + window_.y[t] - pole * window_.y[t - 1];
    filtered_[t] = state;
  }
}

// The stem that the slips of a tracked one make with another deadband.
template <class Real>
void SlipTracker<Real>::lay_path(const Stem& stem, Real deadband) {
  const Real share = Real(1) / static_cast<Real>(window_.decimation);
  Real position = stem.start;
  const bool stops = now_.model.friction.motion == SlipMotion::kStops;
  const Real half = deadband / Real(2);
  int slip = 0;
  int next = stem.slips > 0 ? std::abs(stem.when[0]) - 1 : -1;  // sample of that slip
  int u_index = 0;
  int moves = 0;  // the direction in which it does
  for (Real& mean : x_.first(used_)) {
    if (moves == 0 && (next < 0 || next >= u_index + window_.decimation)) {
      mean = held(position, window_.decimation) * share;
      u_index += window_.decimation;
      continue;
    }
    Real sum = 0;
    for (int k = 0; k < window_.decimation; ++k, ++u_index) {
      if (u_index == next) {
        moves = stem.when[slip] > 0 ? 1 : -1;
        position = window_.u[u_index] - static_cast<Real>(moves) * half;
        ++slip;
        next = slip < stem.slips ? std::abs(stem.when[slip]) - 1 : -1;
        moves = stops ? moves : 0;
      } else if (moves != 0) {
        const Real u = window_.u[u_index];
        const Real before = window_.u[u_index - 1];
        moves = (moves > 0 ? u > before : u < before) ? moves : 0;
        position = moves != 0 ? u - static_cast<Real>(moves) * half : position;
      }
      sum += position;
    }
    mean = sum * share;
  }
}

// The slow pole through which the observer's error sees the stem.
template <class Real>
Real SlipTracker<Real>::seen_slow(const ProcessPoles<Real>& poles) const {
  return poles.slow * (Real(1) - correction_);
}

// Equation (T3) for the stem positions in x: begins it.
template <class Real>
void SlipTracker<Real>::regress(const ProcessPoles<Real>& poles,
                                const DelayRange& delays) {
  if (poles.slow != filtered_pole_) {
    filter_output(poles.slow);
    regression_->forget_output();
  }
  regression_->start_fit(x_.first(used_), filtered_.first(used_),
                         {seen_slow(poles), poles.fast}, delays.first, delays.last, false,
                         true);
  doing_ = Doing::kRegress;
}

template <class Real>
void SlipTracker<Real>::begin_fit_at(const Point& point) {
  laid_ = laid_ && point[0] == point_[0];
  point_ = point;
  poles_ = {integrating_ ? Real(1) : pole_of(elementary::exp(point[1])),
            pole_of(elementary::exp(point[2]))};
  doing_ = Doing::kFilter;
}

// Whether the point is the best one of the round so far.
template <class Real>
bool SlipTracker<Real>::at_best() const {
  return point_[0] == now_.model.friction.deadband && poles_ == now_.model.poles;
}

// What the regression found at the point, and on to the next.
template <class Real>
void SlipTracker<Real>::take_fit() {
  ValveModel<Real>& model = now_.model;
  const ProcessFit<Real>& fit = regression_->result();
  const bool better = first_fit_ || fit.error < model.fit.error;
  settled_ =
      (better ? !first_fit_ && fit.delay == model.fit.delay : settled_ || at_best());
  if (better) {
    model.friction.deadband = point_[0];
    model.poles = poles_;
    model.fit = fit;
    const Real steady = std::max(fit.gain_a + fit.gain_b, Real(1e-6));
    now_.gain = steady * (Real(1) - seen_slow(poles_));
    const PoleFilter<Real> filter({seen_slow(poles_), poles_.fast}, x_.first(used_));
    now_.origin = filter.origin() - fit.offset / steady;
  }
  if (!std::exchange(first_fit_, false)) {
    propose(true);
    return;
  }
  pattern_.start(point_, fit.error, kFits);
  pattern_.add_direction({Real(1)}, Real(0.03) * window_.swing,
                         Real(0.002) * window_.swing);
  if (!integrating_) {
    pattern_.add_direction({Real(0), Real(1)}, Real(0.3), Real(0.02));
  }
  pattern_.add_direction({Real(0), Real(0), Real(1)}, Real(0.5), Real(0.05));
  propose(false);
}

// The next point of the search over deadband and poles (T4); `tried`: after one whose
// error the regression found. Its bounds, or no time constant at all, can make of it the
// best point, whose error is known.
template <class Real>
void SlipTracker<Real>::propose(bool tried) {
  Real error = regression_->result().error;
  do {
    if (tried) {
      pattern_.report(point_, error);
    }
    if (pattern_.done()) {
      doing_ = Doing::kFinish;
      return;
    }
    Point point = pattern_.propose();
    point[0] = std::max(point[0], Real(0));
    point[1] =
        std::min(point[1], elementary::log(window_.period * Real(kIntegratorPeriods)));
    point[2] = std::max(point[2], elementary::log(Real(kNoTimeConstant)));
    begin_fit_at(point);
    tried = settled_ && at_best();
    error = now_.model.fit.error;
  } while (tried);
}

template <class Real>
void SlipTracker<Real>::measure(const ProcessPoles<Real>& poles) {
  used_ = window_.y.size();
  measuring_ = true;
  filtered_pole_ = kNotFiltered;
  regress(poles, every_delay(window_));
}

template <class Real>
Real SlipTracker<Real>::misfit() const {
  return std::sqrt(regression_->result().error / static_cast<Real>(used_));
}

template <class Real>
void SlipTracker<Real>::begin_fits() {
  found_ = (*stems_)[std::max_element(weight_.begin(), weight_.end()) - weight_.begin()];
  const ValveModel<Real>& model = now_.model;
  integrating_ = !(model.poles.slow < Real(1));
  first_fit_ = true;
  laid_ = false;
  filtered_pole_ = kNotFiltered;
  begin_fit_at(
      {found_.deadband,
       integrating_ ? Real(0) : elementary::log(time_constant_of(model.poles.slow)),
       elementary::log(time_constant_of(model.poles.fast))});
}

// Where the motion that began with a slip ended, before the next one.
template <class Real>
int SlipTracker<Real>::stopped_at(int slip, int next) const {
  int last = std::abs(slip) - 1;
  if (now_.model.friction.motion == SlipMotion::kStops) {
    const Real sign = slip > 0 ? Real(1) : Real(-1);
    while (last + 1 < next && sign * (window_.u[last + 1] - window_.u[last]) > Real(0)) {
      ++last;
    }
  }
  return last;
}

// The slip of each stroke from the bounds that the stem's slips set: what held is below
// it, what gave way is above it. The value that breaks the fewest bounds by the least
// lies in the middle of all of them, sorted.
template <class Real>
void SlipTracker<Real>::bound_slips(const Stem& stem) {
  ValveFriction<Real>& friction = now_.model.friction;
  const Real half = friction.deadband / Real(2);
  std::array<Real, 2 * kMostSlips> bounds;
  for (const bool rising : {true, false}) {
    const Real sign = rising ? Real(1) : Real(-1);
    std::size_t count = 0;
    std::size_t held = 0;
    std::size_t gave = 0;
    for (int k = 1; k < stem.slips; ++k) {
      const int to = std::abs(stem.when[k]) - 1;
      const int from = stopped_at(stem.when[k - 1], to);
      const Real position = window_.u[from] + (stem.when[k - 1] > 0 ? -half : half);
      Real largest = sign * (window_.u[from] - position);
      for (int t = from + 1; t < to; ++t) {
        largest = std::max(largest, sign * (window_.u[t] - position));
      }
      bounds[count++] = largest;
      ++held;
      if ((stem.when[k] > 0) == rising) {
        bounds[count++] = sign * (window_.u[to] - position);
        ++gave;
      }
    }
    if (gave < 2) {
      continue;
    }
    const auto middle = bounds.begin() + static_cast<std::ptrdiff_t>(held);
    const auto end = bounds.begin() + static_cast<std::ptrdiff_t>(count);
    std::nth_element(bounds.begin(), middle, end);
    const Real below = *std::max_element(bounds.begin(), middle);
    const Real slip = std::max((below + *middle) / Real(2) - half, Real(0));
    (rising ? friction.slip_ascending : friction.slip_descending) = slip;
  }
}

template <class Real>
void SlipTracker<Real>::finish_round() {
  bound_slips(found_);
  now_.start = found_.start;
  now_.misfit = std::sqrt(now_.model.fit.error / static_cast<Real>(used_));
  // Stems that ran out of room for their slips tell of too little.
  const bool whole = used_ > window_.y.size() / 2;
  if (whole && (started_ || now_.misfit < best_.misfit)) {
    best_ = now_;
    best_.followed = true;
    started_ = false;
  }
}

#define STICKBAND_INSTANTIATE(Real)                                    \
  template void SlipTracker<Real>::regress(const ProcessPoles<Real>&,  \
                                           const DelayRange&);         \
  template void SlipTracker<Real>::measure(const ProcessPoles<Real>&); \
  template Real SlipTracker<Real>::misfit() const;                     \
  template void SlipTracker<Real>::begin_fits();                       \
  template void SlipTracker<Real>::lay_path(const Stem&, Real);        \
  template int SlipTracker<Real>::stopped_at(int, int) const;          \
  template void SlipTracker<Real>::take_fit();                         \
  template void SlipTracker<Real>::finish_round();
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)

}  // namespace ident
