#include "ident/valve/interval_search.hpp"

#include <algorithm>

#include "ident/base/configurations.hpp"

namespace ident {
namespace {

// Deadband, slip ascending, slip descending.
constexpr int kTrades[9][3] = {{1, 0, 0},  {0, 1, 0},  {0, 0, 1},  {-1, 1, 1}, {0, 1, 1},
                               {0, 1, -1}, {-1, 1, 0}, {-1, 0, 1}, {1, 1, 1}};

}  // namespace

template <class Real>
void IntervalSearch<Real>::start(const ValveModel<Real>& model, Real limit, Real swing,
                                 Real margin) {
  best_ = model;
  limit_ = limit;
  swing_ = swing;
  const ValveFriction<Real>& f = model.friction;
  const auto around = [&](Real value) {
    const Real reach = value > Real(0) ? margin : Real(0);
    return typename ValveIntervals<Real>::Bounds{std::max(value - reach, Real(0)),
                                                 value + reach};
  };
  intervals_.stick_ascending = around(f.stick_ascending());
  intervals_.stick_descending = around(f.stick_descending());
  intervals_.slip_ascending = around(f.slip_ascending);
  intervals_.slip_descending = around(f.slip_descending);
  direction_ = 0;
  halving_ = 0;
  reach_ = outside_ = 0;
  asked_ = false;
}

template <class Real>
void IntervalSearch<Real>::include(const ValveModel<Real>& model) {
  if (model.known && model.fit.error <= limit_) {
    widen(model.friction);
  }
}

template <class Real>
void IntervalSearch<Real>::widen(const ValveFriction<Real>& friction) {
  const auto include = [](auto& bounds, Real value) {
    bounds.low = std::min(bounds.low, value);
    bounds.high = std::max(bounds.high, value);
  };
  include(intervals_.stick_ascending, friction.stick_ascending());
  include(intervals_.stick_descending, friction.stick_descending());
  include(intervals_.slip_ascending, friction.slip_ascending);
  include(intervals_.slip_descending, friction.slip_descending);
}

// A share of the swing. Of a valve without a band it is the band that is asked for, which
// is wider than the interval around one.
template <class Real>
Real IntervalSearch<Real>::first_step() const {
  constexpr Real kBeside = Real(0.004);
  constexpr Real kFromNone = Real(0.03);
  const ValveFriction<Real>& f = best_.friction;
  return f.stick_ascending() > Real(0) || f.stick_descending() > Real(0) ? kBeside
                                                                         : kFromNone;
}

// The best model moved by the present trial.
template <class Real>
ValveModel<Real> IntervalSearch<Real>::trial() const {
  const Real sense = direction_ % 2 == 0 ? Real(1) : Real(-1);
  const int* trade = kTrades[direction_ / 2];
  ValveModel<Real> model = best_;
  ValveFriction<Real>& f = model.friction;
  const auto moved = [&](Real value, int weight) {
    return std::max(value + sense * trial_ * static_cast<Real>(weight), Real(0));
  };
  f.deadband = moved(f.deadband, trade[0]);
  f.slip_ascending = moved(f.slip_ascending, trade[1]);
  f.slip_descending = moved(f.slip_descending, trade[2]);
  return model;
}

template <class Real>
void IntervalSearch<Real>::take(const ValveModel<Real>& model) {
  if (model.fit.error <= limit_ && trial_ < Real(2) * swing_) {
    reach_ = trial_;
    widen(model.friction);
  } else {
    outside_ = trial_;
  }
  if (++halving_ >= kHalvings) {
    ++direction_;
    halving_ = 0;
    reach_ = outside_ = 0;
  }
}

template <class Real>
bool IntervalSearch<Real>::step(ValveSearch<Real>& search, int budget) {
  ValvePass<Real>& pass = search.pass();
  for (int left = budget * kUnit; left > 0 && pass.run(left);) {
    if (asked_) {
      take(pass.model());
      asked_ = false;
    }
    if (direction_ >= 2 * kDirections) {
      return true;
    }
    // First steps out by doubling, then between the last inside and the first outside.
    trial_ = outside_ > Real(0) ? (reach_ + outside_) / Real(2)
             : reach_ > Real(0) ? Real(3) * reach_
                                : swing_ * first_step();
    pass.fit(trial(), false);
    asked_ = true;
  }
  return false;
}

template class IntervalSearch<float>;
template class IntervalSearch<double>;

}  // namespace ident
