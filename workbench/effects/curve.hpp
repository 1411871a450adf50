// How the content of a storage depends on what flows out of it.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace workbench {

/// (W2) A monotone curve over from … to with both ends fixed, whose slope changes by the
/// factor exp(curvature) from one end to the other; 0 is a straight line.
struct Curve {
  static constexpr double kEmpty = 0.01;  ///< least slope by head: never quite 0

  double curvature = 0;
  double from = 0;
  double to = 0;
  /// The slope grows in a straight line, as content over outflow of a tank that drains by
  /// its own head; else exponentially. An empty tank stays empty.
  bool by_head = false;

  /// Whether it bends nothing.
  [[nodiscard]] bool is_straight() const;
  [[nodiscard]] double slope(double z) const;
  /// From z to the curve, in place.
  void bend(std::span<double> signal) const;
};

/// Curve::slope with its constants worked out; an exponential is read off a table, to
/// 1.2e-5 of itself. Cost: 3 us, then a few ns for each slope.
class CurveSlope {
 public:
  explicit CurveSlope(const Curve& curve);

  [[nodiscard]] double operator()(double z) const {
    const double place = at_zero_ + rise_ * z;
    if (!exponential_) return place > Curve::kEmpty ? place : Curve::kEmpty;
    constexpr double kLast = static_cast<double>(kPoints - 1) - 1e-9;
    const double inside = !(place > 0) ? 0 : place > kLast ? kLast : place;  // NaN: 0
    const auto i = static_cast<std::size_t>(inside);
    return table_[i] + (inside - static_cast<double>(i)) * (table_[i + 1] - table_[i]);
  }

 private:
  static constexpr std::size_t kPoints = 2049;

  bool exponential_ = false;
  double at_zero_ = 1;  // slope, or place in the table
  double rise_ = 0;
  std::array<double, kPoints> table_{};
};

}  // namespace workbench
