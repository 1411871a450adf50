#include "workbench/effects/common.hpp"

#include <algorithm>
#include <cmath>

namespace workbench::effects {

std::vector<SearchedParameter> searched_lag(const Situation& situation,
                                            std::string_view name) {
  return {{.name = name,
           .unit = "s",
           .low = situation.period_s / 10,
           .high = situation.duration_s() / 5,
           .logarithmic = true,
           .off = 0.0}};
}

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
  return {count_moves(situation.u, situation.u_span() / 8), "moves of u", kLeastMoves};
}

SearchedParameter searched_stem_start(const Situation& situation, std::string_view name) {
  const double span = std::max(situation.u_span(), 1e-12);
  return {.name = name,
          .unit = "u",
          .low = -span,
          .high = span,
          .jumpy = true,
          .initial = true};
}

double stem_resolution(const Situation& situation) {
  std::vector<double> moves;
  for (std::size_t k = 1; k < situation.u.size(); ++k) {
    const double move = std::abs(situation.u[k] - situation.u[k - 1]);
    if (move > 0) moves.push_back(move);
  }
  return std::min(0.1 * quantile(moves, 0.5), 0.01 * situation.u_span());
}

void move_with_friction(const StemFriction& friction, ValveSignal& signal) {
  if (signal.v.empty()) return;
  constexpr double kArrived = 0.02;  // of the slip
  const double half = friction.deadband / 2;
  const double tau = friction.slide_s / signal.period_s;
  const double left = tau > 0 ? std::exp(-1 / tau) : 0;
  const double mean = signal.weight().decay(friction.slide_s);
  double x = signal.v[0] + std::clamp(friction.start, -half - friction.slip_ascending,
                                      half + friction.slip_descending);
  int direction = 0;
  std::size_t at_rest = 0;
  bool resting = true;
  for (double& v : signal.v) {
    const double pull = v - x;
    if (direction <= 0 && pull > half + friction.slip_ascending) {
      direction = 1;
    } else if (direction >= 0 && -pull > half + friction.slip_descending) {
      direction = -1;
    }
    const bool ahead = direction * pull > half;
    if (direction == 0 || !ahead) {
      at_rest += resting;
      v = x;
      if (!friction.keeps_sliding) direction = 0;
      continue;
    }
    resting = false;
    const double goal = v - direction * half;
    const double way = x - goal;
    v = goal + mean * way;
    x = goal + left * way;
    const double slip =
        direction > 0 ? friction.slip_ascending : friction.slip_descending;
    const bool arrived = std::abs(left * way) <= kArrived * slip;
    if (arrived && !friction.keeps_sliding) direction = 0;
  }
  signal.at_rest = at_rest;
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
