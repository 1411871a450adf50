// The physical valve: deadband and slip jump, for each stroke, for any u.
#pragma once

#include <cstdint>
#include <limits>

namespace ident {

/// What happens after the valve has broken free.
enum class SlipMotion : std::uint8_t {
  kSlides,  ///< it follows u; it needs the stick band to turn back, nothing to go on
  kStops,   ///< it follows u until u stops or turns back, if only for one sample; then it
            ///< needs the slip jump to go on (Choudhury 2005, Kano 2004)
  kResticks,  ///< it stops at once and needs the slip jump to go on (He 2007)
};
inline constexpr int kSlipMotions = 3;

/// Parameters of a sticking valve, in units of u, all ≥ 0.
///
/// With static and kinetic friction bands fs and fd for each stroke, u and y see only
/// three combinations, because a constant shift of x is lost in the offset of y:
///   deadband  F = fd_ascending + fd_descending,
///   slip jump J_ascending = fs_ascending − fd_ascending, J_descending likewise,
/// hence the stick bands S_ascending = fs_ascending + fd_descending = F + J_ascending and
/// S_descending = F + J_descending (docs/model.md, (S2) – (S4)). All zero: a
/// linear valve. J = 0: backlash. F = 0 and one J = 0: one-sided stiction.
template <class Real>
struct ValveFriction {
  Real deadband = 0;
  Real slip_ascending = 0;
  Real slip_descending = 0;
  SlipMotion motion = SlipMotion::kSlides;

  [[nodiscard]] Real stick_ascending() const { return deadband + slip_ascending; }
  [[nodiscard]] Real stick_descending() const { return deadband + slip_descending; }
  [[nodiscard]] bool operator==(const ValveFriction&) const = default;
};

/// How many positions are tried where a stem's is looked for.
inline constexpr int kRestingPlaces = 48;

/// The positions at which a stem can rest, units of u.
template <class Real>
struct RestingRange {
  Real lowest = 0;
  Real highest = 0;

  /// `share`: 0 … 1.
  [[nodiscard]] Real at(Real share) const { return lowest + share * (highest - lowest); }
  /// The middle of a part of the range, of kRestingPlaces equal ones; `part` from 0.
  [[nodiscard]] Real place(int part) const {
    return at((static_cast<Real>(part) + Real(0.5)) / Real(kRestingPlaces));
  }
};

/// Where the stem can rest at a given u.
template <class Real>
[[nodiscard]] RestingRange<Real> resting_range(const ValveFriction<Real>& friction,
                                               Real u) {
  const Real half = friction.deadband / Real(2);
  return {u - half - friction.slip_ascending, u + half + friction.slip_descending};
}

/// The valve (S1), sample by sample. Needs neither a constant setpoint nor two extrema a
/// cycle. State: six numbers. Cost of `step`: two comparisons while the stem holds.
template <class Real>
class StickSlipValve {
 public:
  /// The stem rests at `position` (in units of u, where the linear valve has x = u)
  /// until u has left the band around it.
  StickSlipValve(const ValveFriction<Real>& friction, Real position)
      : friction_(friction), position_(position) {
    rest();
  }

  /// Takes the next u, returns the stem position x in units of u.
  Real step(Real u) {
    if (u > upper_ || u < lower_) {
      leave(u);
    }
    return position_;
  }

 private:
  void leave(Real u) {
    if (friction_.motion == SlipMotion::kStops && direction_ != 0) {
      if (direction_ > 0 ? u > extreme_ : u < extreme_) {
        move(u, direction_);
        return;
      }
      direction_ = 0;
      rest();
    }
    if (u > upper_) {
      move(u, 1);
    } else if (u < lower_) {
      move(u, -1);
    }
  }
  // Where the stem holds without regard to how it came there.
  void rest() {
    const Real half = friction_.deadband / Real(2);
    upper_ = position_ + (half + friction_.slip_ascending);
    lower_ = position_ - (half + friction_.slip_descending);
  }
  void move(Real u, int direction) {
    const Real half = friction_.deadband / Real(2);
    direction_ = direction;
    extreme_ = u;
    position_ = direction > 0 ? u - half : u + half;
    switch (friction_.motion) {
      case SlipMotion::kSlides:
        upper_ = direction > 0 ? u : u + friction_.stick_ascending();
        lower_ = direction > 0 ? u - friction_.stick_descending() : u;
        break;
      case SlipMotion::kStops:  // the next u is looked at in any case
        upper_ = std::numeric_limits<Real>::lowest();
        lower_ = std::numeric_limits<Real>::max();
        break;
      case SlipMotion::kResticks:
        rest();
        break;
    }
  }

  ValveFriction<Real> friction_;
  Real position_;
  Real upper_ = 0;  // u above this, or below the other, is looked at
  Real lower_ = 0;
  Real extreme_ = 0;   // u at the newest motion
  int direction_ = 0;  // of the newest motion; 0 before the first, or stopped
};

}  // namespace ident
