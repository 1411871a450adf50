// Values that cannot be meant: a scale that was forgotten, a word order, a register that
// stands at FFFF, show as values far outside the span, and not for a moment.
//
// Far is more than a whole span outside the span: what transmitters and outputs give
// beyond their range stays within a tenth of it. A signal is out of reach when it has
// been far for as long as it may be silent, and within again after as long without a far
// value.
//
// Life: new → take, in order of time. No heap or clock. Cost: constant.
#pragma once

#include <array>
#include <cstdint>

namespace firmware {

class SpanReach {
 public:
  /// `span`: ascending, in units of the values; `patience_us` > 0.
  SpanReach(const std::array<double, 2>& span, std::int64_t patience_us)
      : low_(span[0] - (span[1] - span[0])),
        high_(span[1] + (span[1] - span[0])),
        patience_us_(patience_us) {}

  /// A value; NaN and infinities are far.
  void take(std::int64_t t_us, double value) {
    const bool far = !(value >= low_ && value <= high_);
    if (!any_) last_us_ = t_us;
    any_ = true;
    if (far) far_value_ = value;
    if (far == left_) {
      last_us_ = t_us;
    } else if (t_us - last_us_ > patience_us_) {
      left_ = far;
      last_us_ = t_us;
    }
  }
  /// The signal is out of reach.
  [[nodiscard]] bool left() const { return left_; }
  /// The newest value that was far; 0 before the first.
  [[nodiscard]] double far_value() const { return far_value_; }

 private:
  double low_;
  double high_;
  std::int64_t patience_us_;
  std::int64_t last_us_ = 0;  // of the newest value that was as left_ says
  double far_value_ = 0;
  bool left_ = false;
  bool any_ = false;
};

}  // namespace firmware
