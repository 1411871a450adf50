#include "hal/ne43.hpp"

#include <cmath>

namespace hal {

CurrentState Ne43::take(std::int64_t t_us, double current_ma) {
  const double current = std::isfinite(current_ma) ? current_ma : 0;
  const Failure now = current <= limits_.failure_low_ma    ? Failure::kLow
                      : current >= limits_.failure_high_ma ? Failure::kHigh
                                                           : Failure::kNone;
  if (now != seen_) since_us_ = t_us;
  seen_ = now;
  if (t_us - since_us_ >= limits_.debounce_us) confirmed_ = seen_;
  if (confirmed_ != seen_) {
    // The value is void either way, so a confirmed failure stays in place meanwhile.
    state_ = confirmed_ == Failure::kNone ? CurrentState::kSettling : state_;
  } else if (confirmed_ == Failure::kLow) {
    state_ = CurrentState::kFailureLow;
  } else if (confirmed_ == Failure::kHigh) {
    state_ = CurrentState::kFailureHigh;
  } else {
    const bool inside =
        current > limits_.saturated_low_ma && current < limits_.saturated_high_ma;
    state_ = inside ? CurrentState::kGood : CurrentState::kSaturated;
  }
  return state_;
}

}  // namespace hal
