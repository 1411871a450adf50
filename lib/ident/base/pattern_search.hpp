// A derivative-free minimiser that can be stopped after any evaluation.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace ident {

/// Pattern search over a few coordinates (Hooke and Jeeves 1961) with one step length
/// for each direction: grown by 1.6 on success, halved when both senses fail. Made for
/// objectives that jump, such as the error behind a valve whose slips fall on samples.
/// Life: `start`, then `propose` → evaluate → `report`, until `done`. Fixed memory.
template <class Real>
class PatternSearch {
 public:
  static constexpr int kMaxDimensions = 6;
  static constexpr int kMaxDirections = 10;
  using Point = std::array<Real, kMaxDimensions>;

  /// Starts at `point` with objective `value`; at most `max_evaluations` proposals.
  void start(const Point& point, Real value, int max_evaluations) {
    best_ = point;
    best_value_ = value;
    directions_ = 0;
    current_ = 0;
    sense_ = 1;
    left_ = max_evaluations;
  }
  /// Adds a direction with its first and its smallest useful step length.
  void add_direction(const Point& direction, Real step, Real smallest) {
    direction_[directions_++] = {direction, step, smallest};
  }
  [[nodiscard]] bool done() const {
    return left_ <= 0 ||
           std::none_of(direction_.begin(), direction_.begin() + directions_,
                        [](const Direction& d) { return d.useful(); });
  }
  /// The next point to evaluate; only while not done.
  [[nodiscard]] Point propose() {
    while (!direction_[current_].useful()) {
      advance();
    }
    const Direction& d = direction_[current_];
    Point point = best_;
    for (int i = 0; i < kMaxDimensions; ++i) {
      point[i] += static_cast<Real>(sense_) * d.step * d.way[i];
    }
    return point;
  }
  /// The objective at a point, which may have been moved into its bounds. True if better.
  bool report(const Point& point, Real value) {
    --left_;
    if (better(value)) {
      best_ = point;
      best_value_ = value;
      direction_[current_].step *= Real(1.6);
      advance();
      return true;
    }
    if (sense_ > 0) {
      sense_ = -1;
    } else {
      direction_[current_].step *= Real(0.5);
      advance();
    }
    return false;
  }
  /// A point found in another way; taken if it is better. Counts as an evaluation.
  bool offer(const Point& point, Real value) {
    --left_;
    if (!better(value)) {
      return false;
    }
    best_ = point;
    best_value_ = value;
    return true;
  }
  /// Evaluations that are left.
  [[nodiscard]] int left() const { return left_; }
  [[nodiscard]] const Point& best() const { return best_; }
  [[nodiscard]] Real best_value() const { return best_value_; }

 private:
  struct Direction {
    Point way{};
    Real step = 0;
    Real smallest = 0;  // useful step
    [[nodiscard]] bool useful() const { return step >= smallest; }
  };
  // Trials of a valve that slips at the same samples differ by rounding only: such a gain
  // is none, or the unit of a signal would decide where a search ends.
  [[nodiscard]] bool better(Real value) const {
    constexpr Real kLeastGain = sizeof(Real) < sizeof(double) ? Real(1e-5) : Real(1e-12);
    return value < best_value_ - kLeastGain * std::abs(best_value_);
  }
  void advance() {
    sense_ = 1;
    current_ = current_ + 1 < directions_ ? current_ + 1 : 0;
  }

  Point best_{};
  Real best_value_ = 0;
  std::array<Direction, kMaxDirections> direction_{};
  int directions_ = 0;
  int current_ = 0;
  int sense_ = 1;
  int left_ = 0;
};

}  // namespace ident
