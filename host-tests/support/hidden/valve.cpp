#include "support/hidden/valve.hpp"

#include <algorithm>
#include <cmath>

namespace hidden {

HiddenValve::HiddenValve(const ValvePhysics& physics, double rest_u)
    : physics_(physics),
      rest_(rest_u),
      positioner_(rest_u),
      driven_(rest_u),
      slipping_(rest_u),
      gap_(rest_u),
      stem_(rest_u) {}

double HiddenValve::advance(double signal, double dt_s) {
  if (physics_.positioner_lag_s > 0) {
    positioner_ +=
        (signal - positioner_) * -std::expm1(-dt_s / physics_.positioner_lag_s);
  } else {
    positioner_ = signal;
  }
  limit_rate(positioner_, dt_s);
  if (physics_.sticks()) {
    slip(dt_s);
  } else {
    slipping_ = driven_;
  }
  const double half = physics_.backlash / 2;
  gap_ = std::clamp(gap_, slipping_ - half, slipping_ + half);

  const double stem = std::clamp(gap_, physics_.travel_low, physics_.travel_high);
  const int at_limit = gap_ >= physics_.travel_high  ? 1
                       : gap_ <= physics_.travel_low ? -1
                                                     : 0;
  if (at_limit != 0 && at_limit != at_limit_) {
    ++events_.limit_hits;
  }
  at_limit_ = at_limit;
  count_turn(stem - stem_);
  stem_ = stem;

  const double c = physics_.characteristic;
  return c == 0 ? stem_ : rest_ + std::expm1(c * (stem_ - rest_)) / c;
}

// A stem that follows its drive does not wind up behind its stop.
void HiddenValve::limit_rate(double wanted, double dt_s) {
  if (!physics_.sticks() && physics_.backlash == 0) {
    wanted = std::clamp(wanted, physics_.travel_low, physics_.travel_high);
  }
  const double move = std::clamp(wanted - driven_, -physics_.closing_rate * dt_s,
                                 physics_.opening_rate * dt_s);
  held_back_ = std::abs(wanted - driven_ - move) > 0;
  driven_ += move;
}

void HiddenValve::slip(double dt_s) {
  // Close enough to the end of a slide to rest, as a share of the jump.
  constexpr double kRest = 0.001;
  const double pull = driven_ - slipping_;
  if (sliding_ <= 0 && pull > physics_.static_ascending) {
    sliding_ = 1;
  } else if (sliding_ >= 0 && -pull > physics_.static_descending) {
    sliding_ = -1;
  }
  if (sliding_ == 0) {
    return;
  }
  const bool up = sliding_ > 0;
  const double kinetic = up ? physics_.kinetic_ascending : physics_.kinetic_descending;
  const double jump =
      (up ? physics_.static_ascending : physics_.static_descending) - kinetic;
  const double excess = sliding_ * pull - kinetic;
  if (excess > 0) {
    slipping_ += sliding_ * excess * -std::expm1(-dt_s / physics_.slide_s);
  }
  if (!physics_.keeps_sliding &&
      excess * std::exp(-dt_s / physics_.slide_s) <= kRest * jump) {
    sliding_ = 0;
  }
}

void HiddenValve::count_turn(double move) {
  const int direction = move > 0 ? 1 : move < 0 ? -1 : 0;
  if (direction != 0 && direction != last_turn_) {
    ++events_.turns;
    last_turn_ = direction;
  }
}

}  // namespace hidden
