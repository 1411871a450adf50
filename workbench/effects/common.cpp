#include "workbench/effects/common.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

namespace workbench::effects {

SearchedParameters searched_lag(const Situation& situation, std::string_view name) {
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

Excitation none_between() {
  return {0, "levels of u between its lowest and its highest", kLeastMoves, false};
}

Excitation reversals_beyond(const Situation& situation, double band,
                            std::string_view what) {
  if (takes_two_values(situation)) return none_between();
  return {reversals_of_u(situation, std::max(band, situation.u_span() / 50)), what,
          kLeastMoves, turns(situation)};
}

bool is_overtone_of_u(const Situation& s, double period_s) {
  constexpr double kHardlyMore = 0.9;  // of the variance
  std::vector<double> u(s.u.begin(), s.u.end());
  const double mean = std::reduce(u.begin(), u.end()) / static_cast<double>(u.size());
  for (double& v : u) v -= mean;
  for (const double multiple : {2.0, 3.0, 4.0, 5.0}) {
    for (const double nearby : {0.95, 0.975, 1.0, 1.025, 1.05}) {
      const double swing_s = multiple * nearby * period_s;
      if (line_share(u, s.period_s, swing_s) > kHardlyMore) return true;
    }
  }
  return false;
}

std::vector<double> great_jumps_of_u(const Situation& s) {
  constexpr double kGreat = 0.25;  // of the span of u
  constexpr std::size_t kFew = 10;
  std::vector<double> out;
  for (std::size_t k = 1; k < s.samples(); ++k) {
    if (std::abs(s.u[k] - s.u[k - 1]) < kGreat * s.u_span()) continue;
    out.push_back(static_cast<double>(k) * s.period_s);
  }
  return out.size() <= kFew ? out : std::vector<double>{};
}

bool has_lone_move(std::span<const double> great_jumps) {
  constexpr std::size_t kLone = 2;
  return !great_jumps.empty() && great_jumps.size() <= kLone;
}

bool answers_lone_move(const Situation& s, double time_s) {
  constexpr double kLags = 3;
  constexpr double kMost = 0.25;  // of the recording
  const double lasts =
      std::min(kLags * (s.first_lag_s + s.second_lag_s), kMost * s.duration_s());
  const std::vector<double> jumps = great_jumps_of_u(s);
  return has_lone_move(jumps) && std::ranges::any_of(jumps, [&](double jump_s) {
           return jump_s <= time_s && time_s < jump_s + lasts;
         });
}

SearchedParameter searched_stem_start(const Situation& situation, std::string_view name,
                                      double spans) {
  const double reach = spans * std::max(situation.u_span(), 1e-12);
  return {.name = name,
          .unit = "u",
          .low = -reach,
          .high = reach,
          .jumpy = true,
          .initial = true};
}

SearchedParameter level_of_u(const Situation& situation, std::string_view name) {
  return {.name = name,
          .unit = "u",
          .low = situation.u_low,
          .high = situation.u_high,
          .constant = true};
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
  const double mean = tau > 0 ? signal.weight().decay(friction.slide_s) : 0;
  // At the very end of the band a rounding would decide whether it has moved.
  constexpr double kInside = 1 - 1e-9;
  double x = signal.v[0] + std::clamp(friction.start,
                                      -kInside * (half + friction.slip_ascending),
                                      kInside * (half + friction.slip_descending));
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

double memory_of_noise(std::span<const double> residual) {
  constexpr double kSmall = 0.1;
  const std::size_t n = residual.size();
  double mean = 0;
  for (const double value : residual) mean += value / static_cast<double>(n);
  const auto product = [&](std::size_t lag) {
    double sum = 0;
    for (std::size_t k = lag; k < n; ++k) {
      sum += (residual[k] - mean) * (residual[k - lag] - mean);
    }
    return sum;
  };
  const double power = product(0);
  if (!(power > 0)) return 1;
  double memory = 1;
  for (std::size_t lag = 1; lag < n / 4; ++lag) {
    const double share = product(lag) / power;
    if (share < kSmall) break;
    memory += 2 * share;
  }
  return memory;
}

double student_tail(double t, double degrees) {
  const double z = std::sqrt(degrees * std::log1p(t * t / degrees)) * (8 * degrees + 1) /
                   (8 * degrees + 3);
  return 0.5 * std::erfc((t > 0 ? z : -z) / std::numbers::sqrt2);
}

double load_by_chance(std::span<const double> residual, std::span<const double> load,
                      double places) {
  constexpr double kMemories = 2;
  constexpr double kFewest = 4;
  constexpr double kMost = 60;
  const auto n = static_cast<double>(residual.size());
  const double stretches = n / (kMemories * memory_of_noise(residual));
  if (stretches < kFewest) return 1;
  const auto count = static_cast<std::size_t>(std::min(stretches, kMost));
  std::vector<double> x(count, 0.0);
  std::vector<double> y(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t first = i * residual.size() / count;
    const std::size_t last = (i + 1) * residual.size() / count;
    for (std::size_t k = first; k < last; ++k) {
      x[i] += load[k] / static_cast<double>(last - first);
      y[i] += (load[k] + residual[k]) / static_cast<double>(last - first);
    }
  }
  const auto m = static_cast<double>(count);
  double mean_x = 0;
  double mean_y = 0;
  for (std::size_t i = 0; i < count; ++i) {
    mean_x += x[i] / m;
    mean_y += y[i] / m;
  }
  double xx = 0;
  double xy = 0;
  double yy = 0;
  for (std::size_t i = 0; i < count; ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
    yy += (y[i] - mean_y) * (y[i] - mean_y);
  }
  if (!(xx > 0)) return 1;
  const double degrees = m - 2;
  const double left = std::max((yy - xy * xy / xx) / degrees, 1e-300);
  return std::min(1.0, places * student_tail(xy / std::sqrt(xx * left), degrees));
}

std::vector<double> load_of(const Effect& effect, const Situation& situation, Reals p,
                            double c) {
  ProcessShape shape;
  shape.first_lag_s = situation.first_lag_s;
  shape.second_lag_s = situation.second_lag_s;
  shape.integrating = situation.integrating;
  std::vector<double> out(situation.samples());
  std::span<double> column(out);
  effect.load(p, {situation.period_s, {}, shape, situation.loads}, {&column, 1});
  for (double& value : out) value *= c;
  return out;
}

namespace {

// Power of `signal` at `cycles` cycles in its length, under a Hann window.
double windowed_power(std::span<const double> signal, double cycles) {
  const double angle = 2 * std::numbers::pi / static_cast<double>(signal.size());
  const std::complex<double> turn = std::polar(1.0, -cycles * angle);
  const std::complex<double> bell = std::polar(1.0, angle);
  std::complex<double> w(1, 0);
  std::complex<double> b = std::sqrt(bell);
  std::complex<double> sum(0, 0);
  for (const double value : signal) {
    sum += (1 - b.real()) * value * w;
    w *= turn;
    b *= bell;
  }
  return std::norm(sum);
}

// p-value of a line against a spectrum that is smooth over a few of its widths: power at
// the line over the mean power beside it, on the side where that is more.
double line_by_chance(std::span<const double> signal, double cycles) {
  constexpr int kNearest = 3;  // widths away; nearer ones hold the line itself
  constexpr int kFarthest = 8;
  constexpr double kIndependent = 4;  // of the six, which overlap
  double beside = 0;
  for (const int side : {-1, 1}) {
    double sum = 0;
    int count = 0;
    for (int width = kNearest; width <= kFarthest; ++width) {
      const double at = cycles + side * width;
      if (at < 1 || at > 0.5 * static_cast<double>(signal.size())) continue;
      sum += windowed_power(signal, at);
      ++count;
    }
    if (count > 0) beside = std::max(beside, sum / count);
  }
  if (!(beside > 0)) return 0;
  // F(2, 2 kIndependent); the line was chosen among those within these widths.
  const double ratio = windowed_power(signal, cycles) / beside;
  return std::min(1.0, (kFarthest - kNearest + 1) * 2 *
                           std::pow(1 + ratio / kIndependent, -kIndependent));
}

}  // namespace

double swing_by_chance(std::span<const double> residual, std::span<const double> load,
                       double period) {
  std::vector<double> signal(residual.begin(), residual.end());
  for (std::size_t k = 0; k < signal.size(); ++k) signal[k] += load[k];
  constexpr double kCycles = 2;  // of each stretch
  constexpr double kFewest = 3;
  constexpr double kMost = 12;
  const auto n = static_cast<double>(residual.size());
  const auto count =
      static_cast<std::size_t>(std::clamp(n / (kCycles * period), kFewest, kMost));
  const std::complex<double> turn = std::polar(1.0, -2 * std::numbers::pi / period);
  std::complex<double> sum(0, 0);
  double squares = 0;
  std::complex<double> w(1, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t first = i * residual.size() / count;
    const std::size_t last = (i + 1) * residual.size() / count;
    double mean = 0;
    for (std::size_t k = first; k < last; ++k) {
      mean += signal[k] / static_cast<double>(last - first);
    }
    std::complex<double> amplitude(0, 0);
    for (std::size_t k = first; k < last; ++k) {
      amplitude += (signal[k] - mean) * w / static_cast<double>(last - first);
      w *= turn;
    }
    sum += amplitude;
    squares += std::norm(amplitude);
  }
  const auto m = static_cast<double>(count);
  if (!(squares > 0)) return 1;
  // Of equal stretches with phases of their own the ratio has the distribution of Beta(1,
  // m − 1); the period was chosen among as many within their resolution, either way.
  const double steady = std::norm(sum) / (m * squares);
  const double by_phase =
      std::min(1.0, 2 * m * std::pow(std::max(1 - steady, 0.0), m - 1));
  return std::max(by_phase, line_by_chance(signal, n / period));
}

SearchedParameters curve_parameters(const Situation& situation) {
  return {{.name = "curvature", .unit = "1", .low = -5, .high = 5, .off = 0.0},
          level_of_u(situation, "from"),
          level_of_u(situation, "to")};
}

std::vector<Values> curve_starts(const Situation& situation) {
  std::vector<Values> out;
  for (const double curvature : {-2.0, -0.7, 0.7, 2.0}) {
    out.push_back({curvature, situation.u_low, situation.u_high});
  }
  return out;
}

}  // namespace workbench::effects
