#include "workbench/effects/held_levels.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "workbench/effects/holds.hpp"

namespace workbench {
namespace {

constexpr double kHeldShare = 0.9;       // of the samples
constexpr double kLeastStep = 1.0 / 25;  // of the span of u
constexpr std::size_t kFewestLevels = 6;
constexpr std::size_t kShortestHold = 4;  // samples; the later half has settled

}  // namespace

int levels_held(std::span<const double> u) {
  if (u.empty()) return 0;
  const auto [low, high] = std::ranges::minmax_element(u);
  const double same = effects::same_reading(*low, *high);
  if (effects::held_in(u, same).share < kHeldShare) return 0;
  return count_moves(u, kLeastStep * (*high - *low));
}

std::optional<SettledCurve> SettledCurve::seen_in(const Situation& s) {
  struct Sum {
    double y = 0;
    int count = 0;
  };
  if (s.integrating || levels_held(s.u) == 0) return std::nullopt;
  const double same = effects::same_reading(s.u_low, s.u_high);
  std::map<double, Sum> levels;
  for (std::size_t first = 0; first < s.samples();) {
    std::size_t last = first + 1;
    while (last < s.samples() && std::abs(s.u[last] - s.u[first]) <= same) ++last;
    const bool settled = last - first >= kShortestHold;
    for (std::size_t k = (first + last) / 2; settled && k < last; ++k) {
      if (!s.estimation.empty() && s.estimation[k] == 0) continue;
      Sum& level = levels[s.u[first]];
      level.y += s.y[k];
      ++level.count;
    }
    first = last;
  }
  if (levels.size() < kFewestLevels) return std::nullopt;
  SettledCurve out;
  for (const auto& [u, level] : levels)
    out.points_.emplace_back(u, level.y / level.count);
  return out;
}

double SettledCurve::operator()(double u) const {
  const auto right =
      std::ranges::lower_bound(points_, u, {}, &std::pair<double, double>::first);
  if (right == points_.begin()) return right->second;
  if (right == points_.end()) return points_.back().second;
  const auto& [u_left, y_left] = *(right - 1);
  return std::lerp(y_left, right->second, (u - u_left) / (right->first - u_left));
}

}  // namespace workbench
