#include "workbench/effects/holds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "ident/signal/differences.hpp"
#include "ident/signal/sensor_hold.hpp"
#include "ident/signal/storage.hpp"
#include "workbench/effects/situation.hpp"

namespace workbench::effects {
namespace {

// How often u bends: within the holds of y, and where y jumps out of one.
struct Bends {
  double within = 0;   // share of the samples
  double at_jump = 0;  // share of the jumps
  bool moves = false;  // u does, within the holds
};

Bends bends_of(std::span<const double> u, std::span<const double> y, double same) {
  constexpr std::size_t kInside = 2;  // samples after a jump, which u still answers
  const double straight = ident::measure_differences<double>(u).straight;
  Bends out;
  double inner = 0;
  double jumps = 0;
  double travel = 0;
  std::size_t since = 0;
  for (std::size_t t = 2; t < y.size(); ++t) {
    const bool bends = std::abs(u[t] - 2 * u[t - 1] + u[t - 2]) > straight;
    if (std::abs(y[t] - y[t - 1]) <= same) {
      if (++since <= kInside) continue;
      ++inner;
      out.within += bends;
      travel += std::abs(u[t] - u[t - 1]);
      continue;
    }
    if (since > kInside) {
      ++jumps;
      out.at_jump += bends;
    }
    since = 0;
  }
  out.moves = travel > 0;
  out.within /= std::max(inner, 1.0);
  out.at_jump /= std::max(jumps, 1.0);
  return out;
}

}  // namespace

Holder who_holds(std::span<const double> u, std::span<const double> y) {
  constexpr double kQuiet = 0.2;
  constexpr double kBusy = 0.5;
  constexpr double kAnswers = 0.8;
  if (ident::find_sensor_hold<double>(u, y).sticks) return Holder::kSensor;
  if (ident::find_storage<double>(y).storage != ident::Storage::kHeld) {
    return Holder::kNobody;
  }
  if (ident::find_storage<double>(u).storage != ident::Storage::kEverySample) {
    return Holder::kHistorian;
  }
  const auto [low, high] = std::minmax_element(y.begin(), y.end());
  const Bends bends = bends_of(u, y, same_reading(*low, *high));
  if (bends.within > kBusy) return Holder::kHistorian;
  if (bends.moves && bends.within < kQuiet && bends.at_jump > kAnswers) {
    return Holder::kSensor;
  }
  return Holder::kEither;
}

double same_reading(double low, double high) {
  return 4 * std::numeric_limits<double>::epsilon() *
         std::max(std::abs(low), std::abs(high));
}

void hold_like(std::span<const double> reading, double same, std::span<double> signal) {
  if (signal.empty()) return;
  // A choice of values, not of ways: holds come as they like.
  double last = signal[0];
  for (std::size_t k = 1; k < signal.size(); ++k) {
    const bool holds = std::abs(reading[k] - reading[k - 1]) <= same;
    last = holds ? last : signal[k];
    signal[k] = last;
  }
}

Held held_in(std::span<const double> reading, double same) {
  constexpr double kSmall = 0.05;
  std::vector<double> jumps;
  for (std::size_t k = 1; k < reading.size(); ++k) {
    const double jump = std::abs(reading[k] - reading[k - 1]);
    if (jump > same) jumps.push_back(jump);
  }
  const auto n = static_cast<double>(reading.size());
  return {jumps.size(), 1 - static_cast<double>(jumps.size()) / std::max(n, 1.0),
          jumps.empty() ? 0 : quantile(jumps, kSmall)};
}

}  // namespace workbench::effects
