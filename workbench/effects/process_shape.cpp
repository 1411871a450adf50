#include "workbench/effects/process_shape.hpp"

#include <algorithm>
#include <cmath>

#include "workbench/effects/ringing.hpp"

namespace workbench {

namespace {

// z[k + 1] = left·z[k] + drive(k), `put(k, z[k])` for each k; returns the last z. Four
// samples at a time: within a group the answer to the drive does not wait for z, so that
// one multiplication in four is in the chain.
template <class Drive, class Put>
double follow(std::size_t count, double left, double z, Drive drive, Put put) {
  const double left2 = left * left;
  const double left3 = left2 * left;
  const double left4 = left2 * left2;
  std::size_t k = 0;
  for (; k + 4 <= count; k += 4) {
    const double w0 = drive(k);
    const double w1 = left * w0 + drive(k + 1);
    const double w2 = left * w1 + drive(k + 2);
    const double w3 = left * w2 + drive(k + 3);
    put(k, z);
    put(k + 1, left * z + w0);
    put(k + 2, left2 * z + w1);
    put(k + 3, left3 * z + w2);
    z = left4 * z + w3;
  }
  for (; k < count; ++k) {
    const double w = drive(k);
    put(k, z);
    z = left * z + w;
  }
  return z;
}

}  // namespace

void lag(std::span<const double> in, double period_s, double lag_s, double start,
         std::span<double> out) {
  const double a = lag_s > 0 ? std::exp(-period_s / lag_s) : 0;
  follow(
      in.size(), a, start, [&](std::size_t k) { return (1 - a) * in[k]; },
      [&](std::size_t k, double z) { out[k] = z; });
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
  double before = in[0];
  out[in.size() - 1] = follow(
      in.size() - 1, a, before,
      [&](std::size_t k) {
        const double previous = before;
        before = in[k + 1];
        return (1 - a - slope) * previous + slope * before;
      },
      [&](std::size_t k, double z) { out[k] = z; });
}

void delay(std::span<const double> in, double period_s, double dead_time_s, double lag_s,
           std::span<double> out) {
  const double samples =
      std::clamp(dead_time_s / period_s, 0.0, static_cast<double>(in.size()));
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
  // The second lag is driven by what the first one holds: four samples of that first.
  constexpr std::size_t kGroup = 4;
  double z1 = start;
  double z2 = start;
  for (std::size_t k = 0; k < in.size(); k += kGroup) {
    const std::size_t count = std::min(kGroup, in.size() - k);
    double drive[kGroup] = {};
    z1 = follow(
        count, a1, z1, [&](std::size_t i) { return (1 - a1) * in[k + i]; },
        [&](std::size_t i, double z) {
          drive[i] = link * z + (1 - a2 - link) * in[k + i];
        });
    z2 = follow(
        count, a2, z2, [&](std::size_t i) { return drive[i]; },
        [&](std::size_t i, double z) { out[k + i] = z; });
  }
}

// (W41) The same where the first one fills and empties at different speeds; second_s = 0:
// one.
void directional_lags(const ProcessShape& shape, std::span<const double> in,
                      double period_s, std::span<double> out) {
  struct Way {
    double left;  // of the first lag, after an interval
    double mean;  // of the same, over the interval, as the second lag weighs it
  };
  const IntervalWeight weight{period_s, shape.second_lag_s};
  const auto way = [&](double lag_s) {
    return Way{std::exp(-period_s / lag_s), weight.decay(lag_s)};
  };
  const Way rising = way(shape.first_lag_s);
  const Way falling = way(shape.first_lag_s * shape.falling_over_rising);
  const double second_left =
      shape.second_lag_s > 0 ? std::exp(-period_s / shape.second_lag_s) : 0;
  double z1 = in[0] + shape.start;
  double z2 = z1;
  for (std::size_t k = 0; k < in.size(); ++k) {
    out[k] = shape.second_lag_s > 0 ? z2 : z1;
    const Way& now = in[k] < z1 ? falling : rising;
    const double apart = z1 - in[k];
    const double mean = in[k] + apart * now.mean;
    z2 = mean + (z2 - mean) * second_left;
    z1 = in[k] + apart * now.left;
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

// exp(-x). Where x is small, as it is for lags of many samples, its series: to 1e-12.
double decayed(double x) {
  constexpr double kSmall = 0.125;
  if (!(x < kSmall)) return std::exp(-x);
  const double even = x * x;
  return 1 - x + even * (1.0 / 2 - x / 6 + even * (1.0 / 24 - x / 120)) +
         even * even * even * (1.0 / 720 - x / 5040);
}

// What a lag leaves after a time, both in periods; worked out where the lag is another
// than before.
class LeftAfter {
 public:
  explicit LeftAfter(double time) : time_(time) {}
  double operator()(double lag) {
    if (lag != lag_) {
      lag_ = lag;
      left_ = lag > 0 ? decayed(time_ / lag) : 0;
    }
    return left_;
  }

 private:
  double time_;
  double lag_ = 0;
  double left_ = 0;
};

// A storage whose lag follows its content.
class Storage {
 public:
  Storage(const CurveSlope& slope, double lag) : slope_(slope), lag_(lag) {}

  // Its lag over an interval in which `z` goes towards `goal`: that of halfway.
  double lag(double z, double goal, double falling) {
    const double way = z > goal ? falling : 1;
    return way * lag_ * slope_(goal + (z - goal) * halfway_(way * lag_ * slope_(z)));
  }
  double left(double lag) { return left_(lag); }

 private:
  const CurveSlope& slope_;
  double lag_;  // periods, where the slope is 1
  LeftAfter halfway_{0.5};
  LeftAfter left_{1};
};

// One or two storages whose lags follow their content, or the first of which spills;
// second_s = 0 for one. The second is driven by the mean of what reaches it over the
// interval.
void storages(const ProcessShape& shape, std::span<const double> in, double period_s,
              std::span<double> out) {
  const bool two = shape.second_lag_s > 0;
  const double brim = two ? shape.brim : std::numeric_limits<double>::infinity();
  const CurveSlope slope(shape.storage);
  const double lag_of_first = shape.first_lag_s / period_s;
  const bool constant = two && shape.last_only;
  Storage first(slope, lag_of_first);
  Storage second(slope, shape.second_lag_s / period_s);
  double z1 = std::min(in[0] + shape.start, brim);
  double z2 = in[0] + shape.start;
  for (std::size_t k = 0; k < in.size(); ++k) {
    const double v = in[k];
    const double falling = shape.falling_over_rising;
    const double lag1 =
        constant ? lag_of_first * (z1 > v ? falling : 1) : first.lag(z1, v, falling);
    double left1 = first.left(lag1);
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
      z2 = mean + (z2 - mean) * second.left(second.lag(z2, mean, 1));
    } else {
      z2 = z1;
    }
  }
}

bool spills(const ProcessShape& shape, std::span<const double> in) {
  return shape.second_lag_s > 0 && std::isfinite(shape.brim) &&
         *std::ranges::max_element(in) > shape.brim;
}

// Without what rings and what goes the wrong way.
void slow_response(const ProcessShape& shape, double period_s,
                   std::span<const double> input, std::span<double> out) {
  if (shape.integrating) {
    if (shape.second_lag_s > 0) {
      lag_and_integrator(input, period_s, shape.second_lag_s, out);
    } else {
      integrate(input, period_s, out);
    }
  } else if ((shape.storage.curvature != 0 && shape.first_lag_s > 0) ||
             spills(shape, input)) {
    storages(shape, input, period_s, out);
  } else if (shape.falling_over_rising != 1 && shape.first_lag_s > 0) {
    directional_lags(shape, input, period_s, out);
  } else if (shape.second_lag_s > 0 && shape.first_lag_s > 0) {
    two_lags(input, period_s, shape.first_lag_s, shape.second_lag_s,
             input[0] + shape.start, out);
  } else {
    lag(input, period_s, std::max(shape.first_lag_s, shape.second_lag_s),
        input[0] + shape.start, out);
  }
}

// (1 − b s)/((1 + T1 s)(1 + T2 s)) = (1 + g)/(1 + T1 s) − g/(1 + T2 s), and the same with
// an integrator in place of the first lag.
void subtract_fast_part(const ProcessShape& shape, double period_s,
                        std::span<const double> input, std::span<double> out) {
  const double fast_s = fast_lag_of(shape);
  const double share = shape.integrating
                           ? shape.opposite_s + fast_s
                           : (shape.opposite_s + fast_s) / (shape.first_lag_s - fast_s);
  std::vector<double> fast(input.size());
  if (!shape.integrating && shape.second_lag_s > 0) {
    two_lags(input, period_s, fast_s, shape.second_lag_s, input[0] + shape.start, fast);
  } else {
    lag(input, period_s, fast_s, input[0] + shape.start, fast);
  }
  const double slow = shape.integrating ? 1 : 1 + share;
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = slow * out[k] - share * fast[k];
}

// (W41)
void delay_tail(const ProcessShape& shape, double period_s, std::span<double> out) {
  std::vector<double> tail(out.size());
  lag_of_lines(out, period_s, shape.tail_lag_s, tail);
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k] += shape.tail_share * (tail[k] - out[k]);
  }
}

}  // namespace

double fast_lag_of(const ProcessShape& shape) {
  constexpr double kFaster = 0.9;
  return shape.integrating ? shape.fast_lag_s
                           : std::min(shape.fast_lag_s, kFaster * shape.first_lag_s);
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
  const bool bent = shape.storage.curvature != 0 || std::isfinite(shape.brim) ||
                    shape.falling_over_rising != 1;
  const bool rings = shape.ring_period_s > 0;
  const bool at_once = rings && !(shape.opposite_s > 0) && !bent;
  if (at_once) {
    ring_behind_lags(shape, period_s, input, out);
  } else if (shape.opposite_s > 0) {
    std::vector<double> slow(input.size());
    slow_response(shape, period_s, input, slow);
    subtract_fast_part(shape, period_s, input, slow);
    std::copy(slow.begin(), slow.end(), out.begin());
  } else {
    slow_response(shape, period_s, input, out);
  }
  if (rings && !at_once) ring(shape, period_s, out);
  if (shape.tail_share > 0) delay_tail(shape, period_s, out);
}

void decay(double period_s, double lag_s, std::span<double> out) {
  constexpr double kGone = 1e-30;
  const double a = lag_s > 0 ? std::exp(-period_s / lag_s) : 0;
  double value = 1;
  std::size_t k = 0;
  for (; k < out.size() && value >= kGone; ++k) {
    out[k] = value;
    value *= a;
  }
  std::fill(out.begin() + static_cast<std::ptrdiff_t>(k), out.end(), 0.0);
}

}  // namespace workbench
