// What an earlier window of the same loop found: where the search of the next one starts
// (docs/model.md, (T7)).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "ident/valve/valve_model.hpp"

namespace ident {

/// A valve and its process in units that any later window of the loop understands.
struct EarlierValve {
  ValveFriction<float> friction;  ///< units of u
  /// Time constants of the process in samples of the recording; 0: none, below 0: it
  /// integrates.
  float slow = 0;
  float fast = 0;
  float unexplained = -1;  ///< share of the variance of y that the model left; below 0:
                           ///< there is no model
  /// So many windows more may rest on it without a search for others.
  std::uint8_t trusted = 0;

  [[nodiscard]] bool known() const { return unexplained >= 0.0F; }
};

/// A valve that a search found again is trusted for so many windows.
inline constexpr std::uint8_t kTrustedWindows = 8;

/// Whether two windows found the same valve: the same motion, and stick bands within 5 %
/// of the widest.
[[nodiscard]] inline bool same_valve(const EarlierValve& a, const EarlierValve& b) {
  constexpr float kSame = 0.05F;
  const float least =
      kSame * std::max(a.friction.stick_ascending(), a.friction.stick_descending());
  return a.known() && b.known() && a.friction.motion == b.friction.motion &&
         std::abs(a.friction.stick_ascending() - b.friction.stick_ascending()) < least &&
         std::abs(a.friction.stick_descending() - b.friction.stick_descending()) < least;
}

/// What the next window starts from: `found` in this one, `searched`: not only near the
/// valve `before`. Where none was found it is the one before.
[[nodiscard]] inline EarlierValve next_earlier(const EarlierValve& before,
                                               EarlierValve found, bool searched) {
  if (!found.known()) {
    return before;
  }
  if (same_valve(before, found)) {
    found.trusted = searched ? kTrustedWindows
                             : static_cast<std::uint8_t>(std::max(before.trusted - 1, 0));
  }
  return found;
}

/// `model` with friction in units of u, and poles at the rate of `decimation` samples;
/// fitted to `samples` of unit variance.
template <class Real>
[[nodiscard]] EarlierValve earlier_valve(const ValveModel<Real>& model, int decimation,
                                         std::size_t samples) {
  const auto time_constant = [&](Real pole) {
    if (!(pole < Real(1))) return -1.0F;
    return pole > Real(0) ? static_cast<float>(time_constant_of(pole)) *
                                static_cast<float>(decimation)
                          : 0.0F;
  };
  const ValveFriction<Real>& f = model.friction;
  return {{static_cast<float>(f.deadband), static_cast<float>(f.slip_ascending),
           static_cast<float>(f.slip_descending), f.motion},
          time_constant(model.poles.slow),
          time_constant(model.poles.fast),
          model.known ? static_cast<float>(model.fit.error / static_cast<Real>(samples))
                      : -1.0F};
}

/// The same as a start for a window in which u is scaled by 1 / `u_range` > 0 and y is
/// averaged over `decimation` samples, `samples` of them: friction, poles, and the error
/// that a model as good would leave.
template <class Real>
[[nodiscard]] ValveModel<Real> start_from(const EarlierValve& earlier, Real u_range,
                                          int decimation, std::size_t samples) {
  const auto pole = [&](float time_constant) {
    return time_constant < 0.0F ? Real(1)
                                : pole_of(static_cast<Real>(time_constant) /
                                          static_cast<Real>(decimation));
  };
  ValveModel<Real> model;
  model.known = earlier.known();
  model.fit.error = static_cast<Real>(earlier.unexplained) * static_cast<Real>(samples);
  const auto scaled = [&](float band) { return static_cast<Real>(band) / u_range; };
  model.friction = {scaled(earlier.friction.deadband),
                    scaled(earlier.friction.slip_ascending),
                    scaled(earlier.friction.slip_descending), earlier.friction.motion};
  model.poles = {pole(earlier.slow), pole(earlier.fast)};
  return model;
}

}  // namespace ident
