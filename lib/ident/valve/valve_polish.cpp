#include "ident/valve/valve_polish.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "ident/base/elementary.hpp"

namespace ident {
namespace {

// Where a form can be moved to: deadband, slip ascending, slip descending.
struct Direction {
  ValveForm form;
  std::int8_t deadband;
  std::int8_t ascending;
  std::int8_t descending;
};
constexpr Direction kDirections[] = {
    {ValveForm::kBacklash, 1, 0, 0},   {ValveForm::kAscending, 0, 1, 0},
    {ValveForm::kDescending, 0, 0, 1}, {ValveForm::kSymmetric, 1, 0, 0},
    {ValveForm::kSymmetric, 0, 1, 1},  {ValveForm::kSymmetric, -1, 1, 1},
    {ValveForm::kMixed, 1, 0, 0},      {ValveForm::kMixed, 0, 1, 0},
    {ValveForm::kMixed, 0, 0, 1},      {ValveForm::kMixed, -1, 1, 1},
    {ValveForm::kMixed, 0, 1, -1}};

constexpr double kFirstStep = 0.03;  // of the valve, as a share of the swing of u
constexpr double kLastStep = 0.0007;
constexpr double kLastJumps = 0.005;
constexpr double kFirstTimeStep = 0.4;  // of a time constant's logarithm
constexpr double kLastTimeStep = 0.03;

}  // namespace

template <class Real>
void ValvePolish<Real>::start(ValveForm form, const ValveModel<Real>& model,
                              const SearchWindow<Real>& window, int evaluations,
                              Real jumps) {
  best_ = model;
  swing_ = window.swing;
  longest_ = window.period * Real(kIntegratorPeriods);
  form_ = form;
  jumps_ = form == ValveForm::kMixed || (best_.start_known && form != ValveForm::kLinear);
  reach_ = jumps;
  const Real valve_step = swing_ * std::min(Real(kFirstStep), jumps);
  const Real valve_least = swing_ * Real(kLastStep);
  const Real time_step = Real(kFirstTimeStep);
  const Real time_least = Real(kLastTimeStep);
  pattern_.start(to_point(best_), best_.fit.error, evaluations);
  for (const Direction& d : kDirections) {
    if (d.form == form) {
      pattern_.add_direction(
          {static_cast<Real>(d.deadband), static_cast<Real>(d.ascending),
           static_cast<Real>(d.descending)},
          valve_step, valve_least);
    }
  }
  if (best_.start_known) {
    pattern_.add_direction({0, 0, 0, 0, 0, 1}, valve_step, valve_least);
  }
  if (best_.start_known && form == ValveForm::kMixed) {
    // Deadband against slips, the stem's start going with one stroke or the other.
    pattern_.add_direction({1, -1, -1, 0, 0, Real(0.5)}, valve_step, valve_least);
    pattern_.add_direction({1, -1, -1, 0, 0, Real(-0.5)}, valve_step, valve_least);
  }
  if (best_.poles.slow < Real(1)) {
    pattern_.add_direction({0, 0, 0, 1, 0, 0}, time_step, time_least);
  }
  pattern_.add_direction({0, 0, 0, 0, 1, 0}, Real(2) * time_step, time_least);
}

template <class Real>
ValveModel<Real> ValvePolish<Real>::propose() {
  jumped_ = jumps_ && pattern_.left() % 2 == 0;
  proposed_ = jumped_ ? jump() : pattern_.propose();
  clamp(proposed_);
  return model_at(proposed_);
}

template <class Real>
void ValvePolish<Real>::report(const ValveModel<Real>& model) {
  const bool better = jumped_ ? pattern_.offer(proposed_, model.fit.error)
                              : pattern_.report(proposed_, model.fit.error);
  if (better) {
    best_ = model;
  }
}

template <class Real>
typename ValvePolish<Real>::Point ValvePolish<Real>::to_point(
    const ValveModel<Real>& model) const {
  const Real slow = model.poles.slow < Real(1)
                        ? std::min(time_constant_of(model.poles.slow), longest_)
                        : longest_ * Real(1.01);
  return {model.friction.deadband,
          model.friction.slip_ascending,
          model.friction.slip_descending,
          elementary::log(slow),
          elementary::log(time_constant_of(model.poles.fast)),
          model.start};
}

template <class Real>
ValveModel<Real> ValvePolish<Real>::model_at(const Point& point) const {
  ValveModel<Real> model = best_;
  model.friction = {point[0], point[1], point[2], best_.friction.motion};
  const Real slow = elementary::exp(point[3]);
  model.poles = {slow < longest_ ? pole_of(slow) : Real(1),
                 pole_of(elementary::exp(point[4]))};
  model.start = point[5];
  return model;
}

template <class Real>
void ValvePolish<Real>::clamp(Point& point) const {
  for (int i = 0; i < 3; ++i) {
    point[i] = std::max(point[i], Real(0));
  }
  const Real shortest = elementary::log(Real(kNoTimeConstant));
  const bool integrating = !(best_.poles.slow < Real(1));
  const Real longest = elementary::log(longest_ * Real(integrating ? 1.02 : 0.98));
  point[3] = std::clamp(point[3], shortest, longest);
  point[4] = std::clamp(point[4], shortest, point[3]);
}

// A jump in all coordinates that the form leaves free.
template <class Real>
typename ValvePolish<Real>::Point ValvePolish<Real>::jump() {
  const Real left = static_cast<Real>(pattern_.left()) / Real(kEvaluations);
  const Real reach = swing_ * (Real(kLastJumps) + reach_ * left * left);
  const auto any = [&] {
    const Real way = random_.symmetric();
    return reach * way * std::abs(random_.symmetric());
  };
  Point point = pattern_.best();
  const bool alike = form_ == ValveForm::kSymmetric;
  const bool mixed = form_ == ValveForm::kMixed;
  if (mixed || alike || form_ == ValveForm::kBacklash) {
    point[0] += any();
  }
  if (mixed || alike || form_ == ValveForm::kAscending) {
    point[1] += any();
  }
  if (mixed || form_ == ValveForm::kDescending) {
    point[2] += any();
  }
  point[5] += any();
  if (best_.start_known && (mixed || alike)) {
    // Deadband against slips is the direction in which the data say least.
    const Real trade = reach * random_.symmetric();
    point[0] += trade;
    point[1] -= trade;
    point[2] -= trade;
    point[5] += Real(0.5) * trade * (random_.symmetric() > Real(0) ? Real(1) : Real(-1));
  }
  if (alike) {
    point[2] = point[1];
  }
  return point;
}

template class ValvePolish<float>;
template class ValvePolish<double>;

}  // namespace ident
