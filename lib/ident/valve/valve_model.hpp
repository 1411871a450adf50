// A valve with the process behind it, and the window that both are fitted to.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "ident/base/elementary.hpp"
#include "ident/process/process_regression.hpp"
#include "ident/valve/stick_slip_valve.hpp"

namespace ident {

/// A valve with the process behind it, at the rate of the decimated window.
template <class Real>
struct ValveModel {
  bool known = false;
  ValveFriction<Real> friction;
  ProcessPoles<Real> poles;
  ProcessFit<Real> fit;
  bool start_known = false;  ///< false: the stem starts where one cycle would leave it
  Real start = 0;            ///< stem position before the first sample, scaled like u
};

/// Whether `a` is there and leaves less than `b`, or `b` is not there.
template <class Real>
[[nodiscard]] bool better(const ValveModel<Real>& a, const ValveModel<Real>& b) {
  return a.known && (!b.known || a.fit.error < b.fit.error);
}

/// The window that is searched, oldest sample first.
template <class Real>
struct SearchWindow {
  std::span<const Real> u;  ///< every sample, scaled to 0 … 1
  std::span<const Real> y;  ///< means of `decimation` samples, zero mean, unit variance,
                            ///< sign turned so that the process gain is positive
  int decimation = 1;       ///< samples of u for each of y
  Real period = 0;          ///< of the oscillation, in samples of y
  std::size_t warm_up = 0;  ///< samples of u in the first cycle: where u is next in the
                            ///< state it had at the start, 0 if unknown
  std::size_t first_part = 0;  ///< samples of y that hold the first few reversals of u
  Real swing = 1;              ///< usual distance of two turning points of u, scaled
  bool drift = true;           ///< allow a straight drift of y
};

/// Dead times to try, in samples of y, ends included.
struct DelayRange {
  int first = 1;
  int last = kDelayTaps - 2;
};

/// All of them: within a mean of several samples the newest u may already act on y.
template <class Real>
[[nodiscard]] DelayRange every_delay(const SearchWindow<Real>& window) {
  return {window.decimation > 1 ? 0 : 1, kDelayTaps - 2};
}

/// Those within two samples of `delay`.
template <class Real>
[[nodiscard]] DelayRange delays_near(const SearchWindow<Real>& window, int delay) {
  const DelayRange all = every_delay(window);
  return {std::max(delay - 2, all.first), std::min(delay + 2, all.last)};
}

/// A time constant above this many periods cannot be told from an integrator.
inline constexpr double kIntegratorPeriods = 30;
/// Shorter time constants, in samples of y, are no pole at all.
inline constexpr double kShortestTimeConstant = 0.12;
/// What stands for no pole where a time constant is wanted, in samples of y.
inline constexpr double kNoTimeConstant = 0.1;

/// Pole of a time constant in samples: 0 … below 1.
template <class Real>
[[nodiscard]] Real pole_of(Real time_constant) {
  return time_constant > Real(kShortestTimeConstant)
             ? elementary::exp(Real(-1) / time_constant)
             : Real(0);
}

/// Time constant of a pole below 1, in samples.
template <class Real>
[[nodiscard]] Real time_constant_of(Real pole) {
  return pole > Real(0) ? Real(-1) / elementary::log(pole) : Real(kNoTimeConstant);
}

}  // namespace ident
