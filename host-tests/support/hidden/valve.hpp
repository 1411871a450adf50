// The valve of the hidden-effect loops, in continuous time:
// signal → positioner lag → rate limit → stick-slip → backlash → travel limits →
// characteristic → flow. Advanced in steps that are short against the sample period.
//
// The stick-slip stem is a damper on a spring, without mass: the spring pulls with
// d = signal − stem. At rest the stem holds while −static_descending ≤ d ≤
// static_ascending; sliding, it moves towards d = kinetic friction of that direction with
// the time constant `slide_s`. Static friction is back either as soon as the stem rests
// (the motion of He et al. 2007), or only against turning round, so that the stem goes on
// under kinetic friction (`keeps_sliding`, dwell times much longer than a stop).
#pragma once

#include <limits>

namespace hidden {

inline constexpr double kUnlimited = std::numeric_limits<double>::infinity();

/// Everything in units of u and seconds. The default is a linear valve.
struct ValvePhysics {
  double positioner_lag_s = 0;
  double opening_rate = kUnlimited;  ///< u/s, > 0
  double closing_rate = kUnlimited;  ///< u/s, > 0
  double static_ascending = 0;       ///< friction bands; static ≥ kinetic ≥ 0
  double static_descending = 0;
  double kinetic_ascending = 0;
  double kinetic_descending = 0;
  bool keeps_sliding = false;
  double slide_s = 0;   ///< of the sliding stem, > 0 where there is friction
  double backlash = 0;  ///< whole gap
  double travel_low = -kUnlimited;
  double travel_high = kUnlimited;
  /// Flow = rest + (exp(c·(stem − rest)) − 1)/c: equal-percentage for c = ln R/100,
  /// concave below 0, linear at 0. 1/u.
  double characteristic = 0;

  [[nodiscard]] bool sticks() const {
    return static_ascending > 0 || static_descending > 0;
  }
};

/// What the valve did, for the truth.
struct ValveEvents {
  int turns = 0;       ///< motions of the stem against the motion before
  int limit_hits = 0;  ///< arrivals at a travel limit
};

class HiddenValve {
 public:
  /// At rest with signal, stem and flow at `rest_u`.
  HiddenValve(const ValvePhysics& physics, double rest_u);

  /// Holds `signal` for dt_s, returns the flow at the end, in units of u.
  double advance(double signal, double dt_s);

  [[nodiscard]] double stem() const { return stem_; }
  /// The rate limit held the valve back in the newest step.
  [[nodiscard]] bool held_back() const { return held_back_; }
  [[nodiscard]] const ValveEvents& events() const { return events_; }

 private:
  void limit_rate(double wanted, double dt_s);
  void slip(double dt_s);
  void count_turn(double move);

  ValvePhysics physics_;
  double rest_;
  double positioner_;
  double driven_;      // after the rate limit
  double slipping_;    // stem of the stick-slip stage
  double gap_;         // after the backlash
  double stem_;        // after the travel limits
  int sliding_ = 0;    // direction, 0 at rest
  int last_turn_ = 0;  // direction of the newest motion
  int at_limit_ = 0;
  bool held_back_ = false;
  ValveEvents events_;
};

}  // namespace hidden
