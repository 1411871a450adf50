// The curve of a final element that is two: valves in split range, a drive that turns
// both ways and does not start before its friction is overcome.
#pragma once

#include <span>

namespace workbench {

/// (W40) Straight below and above a dead piece, with another slope above it; both ends of
/// from … to are fixed.
class TwoPieces {
 public:
  /// `ratio` > 0: slope above over slope below. `dead` ≥ 0: width of the piece around
  /// `at` in which nothing changes. All but the ratio in units of u.
  TwoPieces(double from, double to, double at, double dead, double ratio);

  /// Of the way from one end to the other at a share of the range, 0 … 1.
  [[nodiscard]] double share(double at) const;
  /// From u to the curve, in place; beyond the ends as at the ends.
  void bend(std::span<double> signal) const;

  /// Where the pieces end and begin, within from … to.
  [[nodiscard]] double below() const { return from_ + below_ * span_; }
  [[nodiscard]] double above() const { return from_ + above_ * span_; }

 private:
  double from_;
  double span_;
  double below_;  // shares of the range
  double above_;
  double slope_below_;
  double slope_above_;
};

}  // namespace workbench
