#include "ident/verdict/oscillation_cause.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "ident/base/elementary.hpp"
#include "ident/base/limits.hpp"

namespace ident {
namespace {

constexpr double kPi = 3.14159265358979;
constexpr int kFrequencies = 100;
constexpr double kWidest = 2;  // periods looked at, times or by that of the oscillation

// (C1) Share of the movement of u that a setpoint must explain to be its cause.
constexpr double kSetpointMoves = 0.7;
// (C2) A loop is seen to be unstable if its gain at the crossover is above this while u
// rests at a limit for this share of the time, and it oscillates near that crossover.
constexpr double kUnstable = 1.05;
constexpr double kLimited = 0.03;
constexpr double kNearCrossover = 0.25;
constexpr double kExplained = 60;  // fit of the linear valve, %
constexpr double kHolds = 0.4;     // of the linear valve's gain beside the oscillation
// (C3) A load from outside: regular, of constant size, never at a limit.
constexpr double kRegular = 4.2;        // irregularity below 0.1
constexpr double kConstantSize = 1.65;  // kurtosis
constexpr double kFewestCycles = 6;
constexpr double kNeverLimited = 0.01;
// A coarser resolution makes cycles of its own.
constexpr double kCoarse = 0.2;

}  // namespace

std::string_view name(Cause cause) {
  constexpr std::array<std::string_view, kCauses> kNames = {
      "", "valve", "external_periodic", "tight_tuning", "setpoint", "sensor"};
  return kNames[static_cast<std::size_t>(cause)];
}

std::string_view sentence(Cause cause) {
  switch (cause) {
    case Cause::kExternalPeriodic:
      return "The oscillation comes from outside this loop: a periodic load, or another "
             "loop with the same period.";
    case Cause::kTightTuning:
      return "The controller is tuned too tightly: the loop is unstable, and only the "
             "limits of the controller output bound its oscillation.";
    case Cause::kSetpoint:
      return "The moving setpoint is what moves the loop.";
    default:
      return "";
  }
}

template <class Real>
Crossover<Real> crossover(const LinearLoop<Real>& loop, Real period) {
  // From slow to fast; the phase is a sum of parts that each are continuous.
  const Real pi = Real(kPi);
  const Real slow = loop.poles.slow;
  const Real fast = loop.poles.fast;
  const Real steady = unit_gain(loop.poles, static_cast<Real>(loop.samples));
  const Real lag = static_cast<Real>(loop.delay + loop.fit.delay);
  Crossover<Real> found;
  Real before = 0;
  for (int k = 0; k <= kFrequencies; ++k) {
    const Real place = static_cast<Real>(2 * k - kFrequencies) / Real(kFrequencies);
    const Real omega = Real(2) * pi / period * elementary::pow(Real(kWidest), place);
    if (!(omega < pi)) {
      break;
    }
    const Real c = elementary::cos(omega);
    const Real s = elementary::sin(omega);
    const Real law_real = loop.proportional + loop.integral / Real(2);
    const Real law_imaginary =
        -loop.integral / Real(2) / elementary::tan(omega / Real(2));
    const Real taps_real = loop.fit.gain_a + loop.fit.gain_b * c;
    const Real taps_imaginary = -loop.fit.gain_b * s;
    const Real phase = elementary::atan2(law_imaginary, law_real) +
                       elementary::atan2(taps_imaginary, taps_real) - omega * lag -
                       elementary::atan2(slow * s, Real(1) - slow * c) -
                       elementary::atan2(fast * s, Real(1) - fast * c);
    if (k > 0 && before > -pi && phase <= -pi) {
      found.known = true;
      found.period = Real(2) * pi / omega;
      found.gain = steady * elementary::hypot(law_real, law_imaginary) *
                   elementary::hypot(taps_real, taps_imaginary) /
                   (elementary::hypot(Real(1) - slow * c, slow * s) *
                    elementary::hypot(Real(1) - fast * c, fast * s));
      return found;
    }
    before = phase;
  }
  return found;
}

template <class Real>
Real gain_beside(std::span<const Real> y, std::span<const Real> simulated, Real period) {
  // A notch at the period, as wide as a third of its frequency, on both.
  const Real omega = Real(2 * kPi) / period;
  const Real turn = Real(2) * elementary::cos(omega);
  const Real pole = elementary::exp(-omega / Real(6));
  struct Notch {
    Real in[2] = {0, 0};
    Real out[2] = {0, 0};
  };
  const auto step = [&](Notch& notch, Real value) {
    const Real next = value - turn * notch.in[0] + notch.in[1] +
                      pole * turn * notch.out[0] - pole * pole * notch.out[1];
    notch.in[1] = notch.in[0];
    notch.in[0] = value;
    notch.out[1] = notch.out[0];
    notch.out[0] = next;
    return next;
  };
  constexpr Real kSettle = Real(4);  // periods until the notches have forgotten the start
  const std::size_t first = static_cast<std::size_t>(kSettle * period);
  Notch of_y;
  Notch of_simulated;
  Real measured = 0;
  Real modelled = 0;
  Real both = 0;
  for (std::size_t t = 0; t < y.size(); ++t) {
    const Real one = step(of_y, y[t]);
    const Real other = step(of_simulated, simulated[t]);
    if (t >= first) {
      measured += one * one;
      modelled += other * other;
      both += one * other;
    }
  }
  if (!(modelled > Real(0))) {
    return 0;
  }
  const Real gain = both / modelled;
  const Real left = std::max(measured - gain * both, Real(0));
  const Real count = static_cast<Real>(y.size() - first);
  constexpr Real kSigmas = Real(4);  // twice the usual two: what is left is not white
  return gain - kSigmas * std::sqrt(left / (count * modelled));
}

template <class Real>
Real setpoint_share(const LinearLoop<Real>& loop, std::span<const Real> u,
                    std::span<const Real> sp, std::span<Real> scratch) {
  constexpr Real kDiverged = Real(1e6);  // times anything that moves u
  const std::size_t n = u.size();
  const Real slow = loop.poles.slow;
  const Real fast = loop.poles.fast;
  const Real steady = unit_gain(loop.poles, static_cast<Real>(loop.samples));
  const std::size_t lag = static_cast<std::size_t>(loop.delay + loop.fit.delay);
  const std::span<Real> lagged =
      scratch.first(n);  // of the process, before its dead time
  const auto at = [&](std::size_t t, std::size_t back) {
    return t >= back ? lagged[t - back] : Real(0);
  };
  const std::size_t first = n / 10;
  const Real count = static_cast<Real>(n - first);
  Real slow_state = 0;
  Real fast_state = 0;
  Real simulated = 0;
  Real error = 0;
  Real u_mean = 0;
  Real left_mean = 0;
  Real u_square = 0;
  Real left_square = 0;
  for (std::size_t t = 0; t < n; ++t) {
    const Real y = loop.fit.gain_a * at(t, lag) + loop.fit.gain_b * at(t, lag + 1);
    const Real now = sp[t] - sp[0] - y;
    simulated += loop.proportional * (now - error) + loop.integral * now;
    error = now;
    if (!(std::abs(simulated) < kDiverged)) {
      return 0;
    }
    slow_state = slow * slow_state + simulated;
    fast_state = fast * fast_state + slow_state;
    lagged[t] = steady * fast_state;
    if (t >= first) {
      const Real value = u[t] - u[first];
      const Real left = value - simulated;
      u_mean += value / count;
      left_mean += left / count;
      u_square += value * value / count;
      left_square += left * left / count;
    }
  }
  const Real u_variance = u_square - u_mean * u_mean;
  const Real left_variance = left_square - left_mean * left_mean;
  return u_variance > Real(0) ? Real(1) - left_variance / u_variance : Real(0);
}

template <class Real>
bool setpoint_moves(const LoopEvidence<Real>& e) {
  return static_cast<Threshold>(e.setpoint_share) > Threshold(kSetpointMoves);
}

template <class Real>
Cause cause_of(const LoopEvidence<Real>& e, Verdict verdict) {
  if (is_fault(verdict)) {
    return Cause::kValve;
  }
  if (setpoint_moves(e)) {
    return Cause::kSetpoint;
  }
  const bool coarse = static_cast<double>(std::max(e.u_step, e.y_step)) > kCoarse;
  if (verdict != Verdict::kNoStiction || !e.oscillates || !e.law_known || coarse ||
      static_cast<double>(e.cycles) < kFewestCycles) {
    return Cause::kUnknown;
  }
  const double off_crossover = std::abs(static_cast<double>(e.crossover_period) - 1);
  const bool unstable = static_cast<double>(e.crossover_gain) > kUnstable &&
                        off_crossover <= kNearCrossover;
  const bool modelled = static_cast<double>(e.fit_linear_percent) > kExplained &&
                        static_cast<double>(e.gain_beside) > kHolds;
  if (static_cast<double>(e.limit_share) > kLimited && unstable && modelled) {
    return Cause::kTightTuning;
  }
  if (static_cast<double>(e.limit_share) < kNeverLimited &&
      static_cast<double>(e.regularity) > kRegular &&
      static_cast<double>(e.kurtosis) < kConstantSize) {
    return Cause::kExternalPeriodic;
  }
  return Cause::kUnknown;
}

#define STICKBAND_INSTANTIATE(Real)                                                    \
  template Crossover<Real> crossover<Real>(const LinearLoop<Real>&, Real);             \
  template Real gain_beside<Real>(std::span<const Real>, std::span<const Real>, Real); \
  template Real setpoint_share<Real>(const LinearLoop<Real>&, std::span<const Real>,   \
                                     std::span<const Real>, std::span<Real>);          \
  template bool setpoint_moves<Real>(const LoopEvidence<Real>&);                       \
  template Cause cause_of<Real>(const LoopEvidence<Real>&, Verdict);
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)

}  // namespace ident
