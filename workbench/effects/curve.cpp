#include "workbench/effects/curve.hpp"

#include <algorithm>
#include <cmath>

namespace workbench {
namespace {

constexpr double kSteepest = 10.0;  // logarithm of the largest factor of a slope

}  // namespace

CurveSlope::CurveSlope(const Curve& curve) {
  if (curve.is_straight()) return;
  const double span = curve.to - curve.from;
  if (curve.by_head) {
    const double change = std::tanh(curve.curvature / 2);
    at_zero_ = 1 - change - 2 * change * curve.from / span;
    rise_ = 2 * change / span;
    return;
  }
  exponential_ = true;
  constexpr double kStep = 2 * kSteepest / (kPoints - 1);
  at_zero_ = (kSteepest - curve.curvature * curve.from / span) / kStep;
  rise_ = curve.curvature / span / kStep;
  const double ratio = std::exp(kStep);
  double slope = curve.curvature / std::expm1(curve.curvature) * std::exp(-kSteepest);
  for (double& entry : table_) {
    entry = slope;
    slope *= ratio;
  }
}

bool Curve::is_straight() const {
  return !(to - from > 0) || std::abs(curvature) < 1e-7;
}

double Curve::slope(double z) const {
  if (is_straight()) return 1;
  const double span = to - from;
  if (by_head) {
    const double change = std::tanh(curvature / 2);
    return std::max(kEmpty, 1 + change * (2 * (z - from) / span - 1));
  }
  const double rate = curvature / span;
  const double share = std::clamp(rate * (z - from), -kSteepest, kSteepest);
  return curvature / std::expm1(curvature) * std::exp(share);
}

void Curve::bend(std::span<double> signal) const {
  if (is_straight()) return;
  const double span = to - from;
  if (by_head) {
    const double change = std::tanh(curvature / 2);
    const double empty = (change - 1) / (2 * change);  // where the slope is zero
    for (double& value : signal) {
      double share = (value - from) / span;
      share = change > 0 ? std::max(share, empty) : std::min(share, empty);
      value = from + span * share * (1 + change * (share - 1));
    }
    return;
  }
  const double scale = span / std::expm1(curvature);
  const double rate = curvature / span;
  for (double& value : signal) value = from + scale * std::expm1(rate * (value - from));
}

}  // namespace workbench
