#include "workbench/effects/common.hpp"

#include <algorithm>
#include <cmath>

namespace workbench::effects {

std::vector<Values> lag_starts(const Situation& situation) {
  const double h = situation.period_s;
  const double longest =
      std::min(std::max(3 * situation.first_lag_s, 20 * h), situation.duration_s() / 5);
  std::vector<Values> out;
  for (double lag_s = 0.5 * h; lag_s < longest; lag_s *= 2) out.push_back({lag_s});
  out.push_back({longest});
  return out;
}

Excitation moves_of_u(const Situation& situation) {
  const double threshold = situation.u_span() / 10;
  return {threshold > 0 ? count_reversals(situation.u, threshold) : 0, "reversals of u"};
}

void move_with_friction(const ident::ValveFriction<double>& friction,
                        ValveSignal& signal) {
  if (signal.v.empty()) return;
  const double start = signal.v[0];
  ident::StickSlipValve<double> valve(friction, start);
  std::size_t at_rest = 0;
  bool resting = true;
  for (double& v : signal.v) {
    v = valve.step(v);
    resting = resting && v == start;
    at_rest += resting;
  }
  signal.at_rest = at_rest;
}

void bend_curve(double curvature, double from, double to, std::span<double> signal) {
  const double span = to - from;
  if (!(span > 0) || std::abs(curvature) < 1e-7) return;
  const double scale = span / std::expm1(curvature);
  const double rate = curvature / span;
  for (double& value : signal) value = from + scale * std::expm1(rate * (value - from));
}

std::vector<SearchedParameter> curve_parameters(const Situation& situation) {
  return {{.name = "curvature", .unit = "1", .low = -5, .high = 5, .off = 0.0},
          {.name = "from",
           .unit = "u",
           .low = situation.u_low,
           .high = situation.u_high,
           .constant = true},
          {.name = "to",
           .unit = "u",
           .low = situation.u_low,
           .high = situation.u_high,
           .constant = true}};
}

std::vector<Values> curve_starts(const Situation& situation) {
  std::vector<Values> out;
  for (const double curvature : {-2.0, -0.7, 0.7, 2.0}) {
    out.push_back({curvature, situation.u_low, situation.u_high});
  }
  return out;
}

}  // namespace workbench::effects
