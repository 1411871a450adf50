#include "ident/load_rival.hpp"

#include <algorithm>
#include <cmath>

#include "ident/configurations.hpp"

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
  point[kSlow] = std::log(integrates ? period * Real(2 * kIntegratorPeriods) : slow);
  point[kFast] = std::log(std::min(time_constant_of(poles.fast), slow));
  point[kMemory] = std::log(Real(kForgets));
  point[kSmoothing] = std::log(Real(kSmooths));
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
  started_ = false;
  linear_ = 0;
  ratio_ = 1;
}

template <class Real>
void LoadRival<Real>::start_job(ValveSearch<Real>& search, const ValveModel<Real>& valve,
                                std::span<Real> scratch) {
  const ValveModel<Real>& linear = search.best(ValveForm::kLinear);
  const bool integrates =
      job_ == Job::kValve ? !(valve.poles.slow < Real(1)) : job_ == Job::kIntegrating;
  // The linear valve begins with the better one of both processes.
  Point point = point_of(valve.poles, search.window().period, integrates);
  Real error = error_at(search, valve, scratch, point);
  if (job_ != Job::kValve) {
    Point other = point_of(linear.poles, search.window().period, integrates);
    const Real other_error = error_at(search, valve, scratch, other);
    if (other_error < error) {
      point = other;
      error = other_error;
    }
  }
  pattern_.start(point, error, kEvaluations);
  const Real time_least = Real(kLastTimeStep);
  const Real colour_step = Real(kFirstColourStep);
  const Real colour_least = Real(kLastColourStep);
  if (!integrates) {
    pattern_.add_direction({1, 0, 0, 0, 0, 0}, Real(kFirstTimeStep), time_least);
  }
  pattern_.add_direction({0, 1, 0, 0, 0, 0}, Real(2 * kFirstTimeStep), time_least);
  pattern_.add_direction({0, 0, 1, 0, 0, 0}, colour_step, colour_least);
  pattern_.add_direction({0, 0, 0, 1, 0, 0}, colour_step, colour_least);
  pattern_.add_direction({0, 0, 1, 1, 0, 0}, colour_step, colour_least);
  started_ = true;
}

template <class Real>
Real LoadRival<Real>::error_at(ValveSearch<Real>& search, const ValveModel<Real>& valve,
                               std::span<Real> scratch, Point& point) const {
  const SearchWindow<Real>& window = search.window();
  const Real longest = std::log(window.period * Real(kIntegratorPeriods));
  const Real shortest = std::log(Real(kNoTimeConstant));
  point[kSlow] = std::max(point[kSlow], shortest);
  point[kFast] = std::clamp(point[kFast], shortest, std::min(point[kSlow], longest));
  point[kMemory] = std::clamp(point[kMemory], std::log(Real(kForgetsLeast)), Real(0));
  point[kSmoothing] = std::clamp(point[kSmoothing], point[kMemory], Real(0));
  ValveModel<Real> model = job_ == Job::kValve ? valve : search.best(ValveForm::kLinear);
  model.poles = {point[kSlow] < longest ? pole_of(std::exp(point[kSlow])) : Real(1),
                 pole_of(std::exp(point[kFast]))};
  const LoadColour<Real> colour{Real(1) - std::exp(point[kMemory]),
                                Real(1) - std::exp(point[kSmoothing])};
  search.position(model);
  const std::span<Real> x = search.positions();
  const std::span<Real> y = scratch.first(window.y.size());
  std::copy(window.y.begin(), window.y.end(), y.begin());
  whiten(colour, x);
  whiten(colour, y);
  const DelayRange delays = every_delay(window);
  return search.regression()
      .fit(x, y, model.poles, delays.first, delays.last, window.drift)
      .error;
}

template <class Real>
bool LoadRival<Real>::step(ValveSearch<Real>& search, const ValveModel<Real>& valve,
                           std::span<Real> scratch, int budget) {
  for (int left = budget * kUnit; left > 0 && job_ != Job::kDone;) {
    left -= search.cost_of_pass();
    if (!started_) {
      start_job(search, valve, scratch);
      continue;
    }
    if (!pattern_.done()) {
      Point point = pattern_.propose();
      const Real error = error_at(search, valve, scratch, point);
      pattern_.report(point, error);
      continue;
    }
    const Real error = pattern_.best_value();
    started_ = false;
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
  return job_ == Job::kDone;
}

#define STICKBAND_INSTANTIATE(Real)                                     \
  template void whiten<Real>(const LoadColour<Real>&, std::span<Real>); \
  template class LoadRival<Real>;
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)
#undef STICKBAND_INSTANTIATE

}  // namespace ident
