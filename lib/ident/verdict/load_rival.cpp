#include "ident/verdict/load_rival.hpp"

#include <algorithm>

#include "ident/base/configurations.hpp"
#include "ident/base/elementary.hpp"

namespace ident {
namespace {

// Coordinates: logarithms of both time constants, of 1 − memory and of 1 − smoothing.
constexpr int kSlow = 0;
constexpr int kFast = 1;
constexpr int kMemory = 2;
constexpr int kSmoothing = 3;

constexpr double kFirstTimeStep = 0.4;
constexpr double kLastTimeStep = 0.03;
constexpr double kFirstColourStep = 1;
constexpr double kLastColourStep = 0.1;
// What is left of a load after one sample, at first and at least.
constexpr double kForgets = 0.05;
constexpr double kSmooths = 0.5;
constexpr double kForgetsLeast = 1e-4;
// Where a self-regulating start is wanted and the search found none, in periods.
constexpr double kSlowStart = 1;

template <class Real>
typename PatternSearch<Real>::Point point_of(const ProcessPoles<Real>& poles, Real period,
                                             bool integrates) {
  const Real slow =
      poles.slow < Real(1) ? time_constant_of(poles.slow) : period * Real(kSlowStart);
  typename PatternSearch<Real>::Point point{};
  point[kSlow] =
      elementary::log(integrates ? period * Real(2 * kIntegratorPeriods) : slow);
  point[kFast] = elementary::log(std::min(time_constant_of(poles.fast), slow));
  point[kMemory] = elementary::log(Real(kForgets));
  point[kSmoothing] = elementary::log(Real(kSmooths));
  return point;
}

}  // namespace

template <class Real>
void whiten(const LoadColour<Real>& colour, std::span<Real> signal) {
  Real before = signal[0];
  Real white = colour.smoothing < Real(1)
                   ? before * (Real(1) - colour.memory) / (Real(1) - colour.smoothing)
                   : before;
  for (Real& value : signal) {
    white = value - colour.memory * before + colour.smoothing * white;
    before = value;
    value = white;
  }
}

template <class Real>
void LoadRival<Real>::start() {
  job_ = Job::kSelfRegulating;
  doing_ = Doing::kNothing;
  starts_ = 0;
  started_ = false;
  linear_ = 0;
  ratio_ = 1;
}

template <class Real>
bool LoadRival<Real>::integrates(const ValveModel<Real>& valve) const {
  return job_ == Job::kValve ? !(valve.poles.slow < Real(1)) : job_ == Job::kIntegrating;
}

template <class Real>
void LoadRival<Real>::begin_pattern(const ValveModel<Real>& valve) {
  pattern_.start(first_, first_error_, kEvaluations);
  const Real time_least = Real(kLastTimeStep);
  const Real colour_step = Real(kFirstColourStep);
  const Real colour_least = Real(kLastColourStep);
  if (!integrates(valve)) {
    pattern_.add_direction({1, 0, 0, 0, 0, 0}, Real(kFirstTimeStep), time_least);
  }
  pattern_.add_direction({0, 1, 0, 0, 0, 0}, Real(2 * kFirstTimeStep), time_least);
  pattern_.add_direction({0, 0, 1, 0, 0, 0}, colour_step, colour_least);
  pattern_.add_direction({0, 0, 0, 1, 0, 0}, colour_step, colour_least);
  pattern_.add_direction({0, 0, 1, 1, 0, 0}, colour_step, colour_least);
  started_ = true;
}

// Begins to look for the error at a point, moved into its bounds.
template <class Real>
void LoadRival<Real>::evaluate(ValveSearch<Real>& search, const ValveModel<Real>& valve,
                               Point point) {
  const Real longest = elementary::log(search.window().period * Real(kIntegratorPeriods));
  const Real shortest = elementary::log(Real(kNoTimeConstant));
  point[kSlow] = std::max(point[kSlow], shortest);
  point[kFast] = std::clamp(point[kFast], shortest, std::min(point[kSlow], longest));
  point[kMemory] =
      std::clamp(point[kMemory], elementary::log(Real(kForgetsLeast)), Real(0));
  point[kSmoothing] = std::clamp(point[kSmoothing], point[kMemory], Real(0));
  point_ = point;
  poles_ = {point[kSlow] < longest ? pole_of(elementary::exp(point[kSlow])) : Real(1),
            pole_of(elementary::exp(point[kFast]))};
  search.pass().place(job_ == Job::kValve ? valve : search.best(ValveForm::kLinear));
  doing_ = Doing::kPlace;
}

template <class Real>
void LoadRival<Real>::finish_job() {
  const Real error = pattern_.best_value();
  started_ = false;
  starts_ = 0;
  switch (job_) {
    case Job::kSelfRegulating:
      linear_ = error;
      job_ = Job::kIntegrating;
      break;
    case Job::kIntegrating:
      linear_ = std::min(linear_, error);
      job_ = Job::kValve;
      break;
    default:
      ratio_ = error > Real(0) ? linear_ / error : Real(1);
      job_ = Job::kDone;
      break;
  }
}

// The error at the point that was evaluated.
template <class Real>
void LoadRival<Real>::take(ValveSearch<Real>& search, const ValveModel<Real>& valve,
                           Real error) {
  doing_ = Doing::kNothing;
  if (started_) {
    pattern_.report(point_, error);
    return;
  }
  if (starts_++ == 0 || error < first_error_) {
    first_ = point_;
    first_error_ = error;
  }
  // The linear valve begins with the better one of both processes.
  if (starts_ == 1 && job_ != Job::kValve) {
    evaluate(search, valve,
             point_of(search.best(ValveForm::kLinear).poles, search.window().period,
                      integrates(valve)));
  } else {
    begin_pattern(valve);
  }
}

// The smallest piece of work; returns its cost.
template <class Real>
int LoadRival<Real>::piece(ValveSearch<Real>& search, const ValveModel<Real>& valve,
                           std::span<Real> scratch) {
  constexpr int kPerWhitened = 30;
  constexpr int kCostOfDecision = 2;
  const SearchWindow<Real>& window = search.window();
  ProcessRegression<Real>& regression = search.pass().regression();
  switch (doing_) {
    case Doing::kNothing:
      if (!started_) {
        evaluate(search, valve, point_of(valve.poles, window.period, integrates(valve)));
      } else if (!pattern_.done()) {
        evaluate(search, valve, pattern_.propose());
      } else {
        finish_job();
      }
      return kCostOfDecision;
    case Doing::kPlace: {
      const int cost = search.pass().step();
      doing_ = search.pass().done() ? Doing::kWhiten : Doing::kPlace;
      return cost;
    }
    case Doing::kWhiten: {
      const LoadColour<Real> colour{Real(1) - elementary::exp(point_[kMemory]),
                                    Real(1) - elementary::exp(point_[kSmoothing])};
      const std::span<Real> x = search.pass().positions();
      const std::span<Real> y = scratch.first(window.y.size());
      std::copy(window.y.begin(), window.y.end(), y.begin());
      whiten(colour, x);
      whiten(colour, y);
      const DelayRange delays = every_delay(window);
      regression.start_fit(x, y, poles_, delays.first, delays.last, window.drift);
      doing_ = Doing::kRegress;
      return static_cast<int>(y.size()) * kPerWhitened / 1000 + 1;
    }
    case Doing::kRegress:
      break;
  }
  const int cost = regression.cost_of_step();
  if (regression.step()) {
    take(search, valve, regression.result().error);
  }
  return cost;
}

template <class Real>
bool LoadRival<Real>::step(ValveSearch<Real>& search, const ValveModel<Real>& valve,
                           std::span<Real> scratch, int budget) {
  for (int left = budget * kUnit; left > 0 && job_ != Job::kDone;) {
    left -= piece(search, valve, scratch);
  }
  return job_ == Job::kDone;
}

#define STICKBAND_INSTANTIATE(Real)                                     \
  template void whiten<Real>(const LoadColour<Real>&, std::span<Real>); \
  template class LoadRival<Real>;
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)

}  // namespace ident
