#include "workbench/effects/process_shape.hpp"

#include <algorithm>
#include <cmath>

namespace workbench {

void lag(std::span<const double> in, double period_s, double lag_s, double start,
         std::span<double> out) {
  const double a = lag_s > 0 ? std::exp(-period_s / lag_s) : 0;
  double z = start;
  for (std::size_t k = 0; k < in.size(); ++k) {
    const double next = a * z + (1 - a) * in[k];
    out[k] = z;
    z = next;
  }
}

double IntervalWeight::decay(double lag_s) const {
  if (!(lag_s > 0)) return 0;
  const double a = std::exp(-period_s / lag_s);
  if (!(next_s > 0)) return (1 - a) * lag_s / period_s;
  const double b = std::exp(-period_s / next_s);
  const double apart = lag_s - next_s;
  return std::abs(apart) > 1e-6 * next_s ? lag_s * (a - b) / (apart * (1 - b))
                                         : period_s / next_s * b / (1 - b);
}

double IntervalWeight::ramp_down(double end_s) const {
  if (!(end_s > 0)) return 0;
  if (!(next_s > 0.02 * period_s)) return next_s > 0 ? 0 : 0.5 * end_s / period_s;
  const double b = std::exp(-period_s / next_s);
  const double area = next_s * (next_s / end_s * std::expm1(end_s / next_s) - 1);
  return b * area / (next_s * (1 - b));
}

void lag_means(const IntervalWeight& weight, double lag_s, std::span<double> signal) {
  if (signal.empty() || !(lag_s > 0)) return;
  const double a = std::exp(-weight.period_s / lag_s);
  const double mean = weight.decay(lag_s);
  double z = signal[0];
  for (double& value : signal) {
    const double in = value;
    value = in + mean * (z - in);
    z = in + a * (z - in);
  }
}

void lag_of_lines(std::span<const double> in, double period_s, double lag_s,
                  std::span<double> out) {
  if (in.empty()) return;
  const double a = lag_s > 0 ? std::exp(-period_s / lag_s) : 0;
  const double slope = 1 - (1 - a) * lag_s / period_s;
  double previous = in[0];
  double z = in[0];
  out[0] = z;
  for (std::size_t k = 1; k < in.size(); ++k) {
    const double next = in[k];
    z = a * z + ((1 - a - slope) * previous + slope * next);
    previous = next;
    out[k] = z;
  }
}

void delay(std::span<const double> in, double period_s, double dead_time_s, double lag_s,
           std::span<double> out) {
  const double samples = dead_time_s / period_s;
  const auto whole = static_cast<std::size_t>(samples);
  double rest = samples - static_cast<double>(whole);
  if (lag_s > 0) {
    const double a = std::exp(-period_s / lag_s);
    rest = (std::exp(-(1 - rest) * period_s / lag_s) - a) / (1 - a);
  }
  for (std::size_t k = in.size(); k-- > 0;) {
    const double near = k >= whole ? in[k - whole] : in[0];
    const double far = k > whole ? in[k - whole - 1] : in[0];
    out[k] = near + rest * (far - near);
  }
}

namespace {

void integrate(std::span<const double> in, double period_s, std::span<double> out) {
  double z = 0;
  for (std::size_t k = 0; k < in.size(); ++k) {
    const double next = z + period_s * in[k];
    out[k] = z;
    z = next;
  }
}

// Two lags in series. Between samples the second is driven by an exponential, not by a
// constant: with w = z1 - in, z2' = in + a2 (z2 - in) + w T1 (a1 - a2)/(T1 - T2).
void two_lags(std::span<const double> in, double period_s, double first_s,
              double second_s, double start, std::span<double> out) {
  const double a1 = std::exp(-period_s / first_s);
  const double a2 = std::exp(-period_s / second_s);
  const double apart = first_s - second_s;
  const double link = std::abs(apart) > 1e-6 * first_s ? first_s * (a1 - a2) / apart
                                                       : period_s / first_s * a1;
  double z1 = start;
  double z2 = start;
  for (std::size_t k = 0; k < in.size(); ++k) {
    const double v = in[k];
    out[k] = z2;
    z2 = a2 * z2 + (link * z1 + (1 - a2 - link) * v);
    z1 = a1 * z1 + (1 - a1) * v;
  }
}

// An integrator behind a lag: ∫ z1 over an interval is h v + T1 (1 - a1) (z1 - v).
void lag_and_integrator(std::span<const double> in, double period_s, double lag_s,
                        std::span<double> out) {
  const double a = std::exp(-period_s / lag_s);
  const double link = lag_s * (1 - a);
  double z1 = in[0];
  double z2 = 0;
  for (std::size_t k = 0; k < in.size(); ++k) {
    const double v = in[k];
    out[k] = z2;
    z2 += period_s * v + link * (z1 - v);
    z1 = v + a * (z1 - v);
  }
}

// The slope halfway through an interval in which `z` goes towards `goal` with a lag of
// `lag` periods times the slope.
double slope_underway(const Curve& curve, double z, double goal, double lag) {
  const double start = lag * curve.slope(z);
  return curve.slope(start > 0 ? goal + (z - goal) * std::exp(-0.5 / start) : goal);
}

// One or two storages whose lags follow their content, or the first of which spills;
// second_s = 0 for one. The second is driven by the mean of what reaches it over the
// interval.
void storages(const ProcessShape& shape, std::span<const double> in, double period_s,
              std::span<double> out) {
  const bool two = shape.second_lag_s > 0;
  const double brim = two ? shape.brim : std::numeric_limits<double>::infinity();
  double z1 = std::min(in[0] + shape.start, brim);
  double z2 = in[0] + shape.start;
  for (std::size_t k = 0; k < in.size(); ++k) {
    const double v = in[k];
    const double lag1 =
        shape.first_lag_s / period_s *
        (two && shape.last_only
             ? 1
             : slope_underway(shape.storage, z1, v, shape.first_lag_s / period_s));
    double left1 = lag1 > 0 ? std::exp(-1 / lag1) : 0;
    const double way = z1 - v;
    z1 = v + way * left1;
    double lost = 0;
    if (z1 > brim) {
      // Full on the way: from then on what comes in leaves again.
      left1 = way < 0 ? std::min(1.0, (v - brim) / -way) : 1;
      const double full = 1 + (left1 > 0 ? lag1 * std::log(left1) : 0);
      lost = (1 - shape.spill_share) * full * (v - brim);
      z1 = brim;
    }
    const double mean = v + way * lag1 * (1 - left1) - lost;
    out[k] = z2;
    if (two) {
      const double lag2 =
          shape.second_lag_s / period_s *
          slope_underway(shape.storage, z2, mean, shape.second_lag_s / period_s);
      z2 = mean + (z2 - mean) * std::exp(-1 / lag2);
    } else {
      z2 = z1;
    }
  }
}

bool spills(const ProcessShape& shape, std::span<const double> in) {
  return shape.second_lag_s > 0 && std::isfinite(shape.brim) &&
         *std::max_element(in.begin(), in.end()) > shape.brim;
}

}  // namespace

bool Curve::is_straight() const {
  return !(to - from > 0) || std::abs(curvature) < 1e-7;
}

double Curve::slope(double z) const {
  const double span = to - from;
  if (is_straight()) return 1;
  if (by_head) {
    constexpr double kEmpty = 0.01;
    const double change = std::tanh(curvature / 2);
    return std::max(kEmpty, 1 + change * (2 * (z - from) / span - 1));
  }
  const double rate = curvature / span;
  const double share = std::clamp(rate * (z - from), -10.0, 10.0);
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

void respond(const ProcessShape& shape, double period_s, std::span<const double> in,
             std::vector<double>& scratch, std::span<double> out) {
  if (in.empty()) return;
  std::span<const double> input = in;
  if (shape.dead_time_s > 0) {
    scratch.resize(in.size());
    delay(in, period_s, shape.dead_time_s, shape.integrating ? 0 : shape.first_lag_s,
          scratch);
    input = scratch;
  }
  if (shape.integrating) {
    if (shape.second_lag_s > 0) {
      lag_and_integrator(input, period_s, shape.second_lag_s, out);
    } else {
      integrate(input, period_s, out);
    }
  } else if ((shape.storage.curvature != 0 && shape.first_lag_s > 0) ||
             spills(shape, input)) {
    storages(shape, input, period_s, out);
  } else if (shape.second_lag_s > 0 && shape.first_lag_s > 0) {
    two_lags(input, period_s, shape.first_lag_s, shape.second_lag_s,
             input[0] + shape.start, out);
  } else {
    lag(input, period_s, std::max(shape.first_lag_s, shape.second_lag_s),
        input[0] + shape.start, out);
  }
}

void decay(double period_s, double lag_s, std::span<double> out) {
  const double a = lag_s > 0 ? std::exp(-period_s / lag_s) : 0;
  double value = 1;
  for (double& x : out) {
    x = value;
    value *= a;
    if (value < 1e-30) value = 0;
  }
}

}  // namespace workbench
