#include "workbench/effects/situation.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/recording/statistics.hpp"

namespace workbench {
namespace {

using Complex = std::complex<double>;

// In place, radix 2; the length is a power of two.
void fourier(std::vector<Complex>& x) {
  const std::size_t n = x.size();
  for (std::size_t i = 1, j = 0; i < n; ++i) {
    std::size_t bit = n >> 1;
    for (; j & bit; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(x[i], x[j]);
  }
  for (std::size_t length = 2; length <= n; length <<= 1) {
    const double angle = -2 * std::numbers::pi / static_cast<double>(length);
    const Complex turn(std::cos(angle), std::sin(angle));
    for (std::size_t start = 0; start < n; start += length) {
      Complex w(1, 0);
      for (std::size_t k = 0; k < length / 2; ++k) {
        const Complex even = x[start + k];
        const Complex odd = x[start + k + length / 2] * w;
        x[start + k] = even + odd;
        x[start + k + length / 2] = even - odd;
        w *= turn;
      }
    }
  }
}

// The residual on the estimation samples less its mean there, 0 elsewhere.
std::vector<double> fitted_residual(const Situation& s) {
  std::vector<double> out(s.residual.begin(), s.residual.end());
  double sum = 0;
  double count = 0;
  for (std::size_t k = 0; k < out.size(); ++k) {
    sum += s.estimation[k] ? out[k] : 0;
    count += s.estimation[k] ? 1 : 0;
  }
  const double mean = count > 0 ? sum / count : 0;
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k] = s.estimation[k] ? out[k] - mean : 0;
  }
  return out;
}

}  // namespace

std::string Situation::when(double seconds, int digits) const {
  if (pieces.empty()) return number(seconds, digits) + " s";
  const Piece* at = &pieces[0];
  for (const Piece& piece : pieces) {
    // Between two samples, nearer to the later one: what begins there begins with it.
    if (seconds > (static_cast<double>(piece.first) - 0.5) * period_s) at = &piece;
  }
  const double since = seconds - static_cast<double>(at->first) * period_s;
  constexpr double kClock = 1e8;  // s; from 1970 on: nobody reads an instant off it
  const bool alone = pieces.front().recording == pieces.back().recording;
  if (at->start_s > kClock) {
    return filled(
        alone ? "{0} s after the first sample" : "{0} s after the first sample of {1}",
        {number(since, digits), at->recording});
  }
  const std::string time = instant(at->start_s + since, period_s, digits);
  return alone ? time + " s" : filled("{0} s of {1}", {time, at->recording});
}

Situation situation_of(std::span<const double> u, std::span<const double> y,
                       double period_s) {
  Situation s;
  s.period_s = period_s;
  s.u = u;
  s.y = y;
  const auto [u_low, u_high] = std::ranges::minmax_element(u);
  const auto [y_low, y_high] = std::ranges::minmax_element(y);
  s.u_low = *u_low;
  s.u_high = *u_high;
  s.y_low = *y_low;
  s.y_high = *y_high;
  return s;
}

double quantile(std::span<const double> values, double share) {
  std::vector<double> sorted(values.begin(), values.end());
  if (sorted.empty()) return 0;
  std::ranges::sort(sorted);
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

int count_reversals(std::span<const double> signal, double threshold) {
  if (signal.empty()) return 0;
  int count = 0;
  int direction = 0;
  double high = signal[0];
  double low = signal[0];
  for (const double value : signal) {
    high = std::max(high, value);
    low = std::min(low, value);
    if (direction >= 0 && high - value > threshold) {
      count += direction > 0;
      direction = -1;
      low = value;
    } else if (direction <= 0 && value - low > threshold) {
      count += direction < 0;
      direction = 1;
      high = value;
    }
  }
  return count;
}

int reversals_of_u(const Situation& situation, double threshold) {
  if (situation.pieces.empty()) return count_reversals(situation.u, threshold);
  int count = 0;
  for (const Piece& piece : situation.pieces) {
    count += count_reversals(situation.u.subspan(piece.first, piece.last - piece.first),
                             threshold);
  }
  return count;
}

bool turns(const Situation& situation) {
  constexpr double kSmall = 0.02;  // of the span of u
  return reversals_of_u(situation, kSmall * situation.u_span()) > 0;
}

bool takes_two_values(const Situation& situation) {
  constexpr double kNear = 0.02;     // of the span of u
  constexpr double kPassing = 0.02;  // of the samples
  const double reach = kNear * situation.u_span();
  const auto is_between = [&](std::size_t k) {
    const double u = situation.u[k];
    return u > situation.u_low + reach && u < situation.u_high - reach;
  };
  // A row that is the mean over a move lies alone.
  std::size_t between = 0;
  for (std::size_t k = 0; k < situation.samples(); ++k) {
    const bool before = k > 0 && is_between(k - 1);
    const bool after = k + 1 < situation.samples() && is_between(k + 1);
    between += is_between(k) && (before || after) ? 1 : 0;
  }
  return static_cast<double>(between) <=
         kPassing * static_cast<double>(situation.samples());
}

int count_moves(std::span<const double> signal, double size) {
  int count = 0;
  double anchor = signal.empty() ? 0 : signal[0];
  for (const double value : signal) {
    if (!(std::abs(value - anchor) > size)) continue;
    anchor = value;
    ++count;
  }
  return count;
}

int count_stays(std::span<const double> signal, double level, bool above,
                std::size_t memory) {
  constexpr std::size_t kApart = 3;
  int count = 0;
  std::size_t away = kApart;
  std::size_t since = 0;
  for (const double value : signal) {
    const bool beyond = above ? value > level : value < level;
    if (beyond && (away >= kApart || since >= memory)) {
      ++count;
      since = 0;
    }
    ++since;
    away = beyond ? 0 : away + 1;
  }
  return count;
}

std::size_t memory_of(const Situation& situation) {
  const double samples = 3 * situation.first_lag_s / situation.period_s;
  return static_cast<std::size_t>(std::clamp(samples, 5.0, 1e15));
}

namespace {

std::vector<double> strongest_lines(std::span<const double> signal, double longest,
                                    int count) {
  std::size_t length = 2;
  while (length < 2 * signal.size()) length *= 2;
  std::vector<Complex> x(length);
  std::copy(signal.begin(), signal.end(), x.begin());
  fourier(x);
  std::vector<double> power(length / 4);
  for (std::size_t i = 0; i < power.size(); ++i) power[i] = std::norm(x[i]);
  const auto first =
      static_cast<std::size_t>(std::ceil(static_cast<double>(length) / longest));
  const std::size_t resolution = 2 * (length / signal.size() + 1);
  std::vector<double> periods;
  while (static_cast<int>(periods.size()) < count && first < power.size()) {
    const auto peak = std::max_element(power.begin() + first, power.end());
    const auto at = static_cast<std::size_t>(peak - power.begin());
    if (!(*peak > 0)) break;
    periods.push_back(static_cast<double>(length) / static_cast<double>(at));
    const std::size_t from = at > resolution ? at - resolution : 0;
    const std::size_t to = std::min(at + resolution + 1, power.size());
    std::fill(power.begin() + from, power.begin() + to, 0.0);
  }
  return periods;
}

}  // namespace

std::vector<double> strongest_periods(const Situation& situation, double longest,
                                      int count) {
  return strongest_lines(fitted_residual(situation), longest, count);
}

double strongest_period(std::span<const double> signal, double period_s) {
  const auto lines =
      strongest_lines(centred(signal), static_cast<double>(signal.size()) / 3, 1);
  return lines.empty() ? period_s * static_cast<double>(signal.size())
                       : period_s * lines[0];
}

double line_share(std::span<const double> signal, double period_s, double line_s) {
  const std::vector<double> v = centred(signal);
  const Complex turn = std::polar(1.0, -2 * std::numbers::pi * period_s / line_s);
  Complex w(1, 0);
  Complex sum(0, 0);
  double power = 0;
  for (const double value : v) {
    sum += value * w;
    w *= turn;
    power += value * value;
  }
  const auto n = static_cast<double>(v.size());
  return power > 0 ? 2 * std::norm(sum) / (n * power) : 0;
}

namespace {

// Unit of the last decimal that the levels are written with; 0 where it is below `least`.
double last_decimal(std::span<const double> levels, double least) {
  constexpr double kWhole = 1e-6;  // of a unit
  for (double unit = 1; unit > least; unit /= 10) {
    const bool whole = std::ranges::all_of(levels, [unit](double level) {
      return std::abs(level / unit - std::round(level / unit)) < kWhole;
    });
    if (whole) return unit;
  }
  return 0;
}

// How far off its place a level of a lattice may be written, in steps: by the last
// decimal of the file, and a little where it has more decimals.
double off_place(std::span<const double> levels, double step) {
  constexpr double kLeast = 0.05;
  constexpr double kMost = 0.1;
  return std::clamp(last_decimal(levels, kLeast * step) / step, kLeast, kMost);
}

// Step of a converter whose levels the file rounds to two or three of its last decimals
// apart: each is as far from the next to that decimal, and the signal comes back to them;
// what leaves an exception band stands anywhere. 0 where they are of another kind.
double step_of_rounded(std::span<const double> levels, std::span<const double> gaps,
                       std::span<const double> signal) {
  constexpr std::size_t kFewest = 8;
  constexpr double kComesBack = 1.5;  // moves a level
  const auto [least, most] = std::ranges::minmax_element(gaps);
  const double unit = last_decimal(levels, *least / 4);
  if (levels.size() < kFewest || unit == 0 || *least < 1.5 * unit ||
      *most > *least + 1.5 * unit) {
    return 0;
  }
  double moves = 0;
  for (std::size_t k = 1; k < signal.size(); ++k) moves += signal[k] != signal[k - 1];
  if (moves < kComesBack * static_cast<double>(levels.size())) return 0;
  return (levels.back() - levels.front()) / static_cast<double>(gaps.size());
}

}  // namespace

Lattice lattice_of(std::span<const double> signal) {
  std::vector<double> values(signal.begin(), signal.end());
  std::ranges::sort(values);
  if (values.empty()) return {};
  const double span = values.back() - values.front();
  if (!(span > 0)) return {};
  const double same = 1e-9 * std::max(std::abs(values.front()), std::abs(values.back()));
  std::vector<double> levels = {values.front()};
  for (const double value : values) {
    if (value - levels.back() > same + 1e-6 * span) levels.push_back(value);
  }
  if (levels.size() < 3 || 2 * levels.size() > values.size()) return {};
  std::vector<double> gaps;
  for (std::size_t i = 1; i < levels.size(); ++i) {
    gaps.push_back(levels[i] - levels[i - 1]);
  }
  if (const double step = step_of_rounded(levels, gaps, signal); step > 0) {
    return {step, 1, levels.size()};
  }
  // The step is the usual gap; refined over all levels so that rounded stamps do not add
  // up, then checked against every value.
  double step = quantile(gaps, 0.25);
  for (int pass = 0; pass < 3; ++pass) {
    double product = 0;
    double square = 0;
    const double reach = pass == 0 ? 20 * step : span;
    for (const double level : levels) {
      const double distance = level - levels[levels.size() / 2];
      if (std::abs(distance) > reach) continue;
      const double index = std::round(distance / step);
      product += index * distance;
      square += index * index;
    }
    if (!(square > 0)) return {};
    step = product / square;
  }
  std::size_t on = 0;
  const double off = off_place(levels, step);
  for (const double value : values) {
    const double place = (value - levels[levels.size() / 2]) / step;
    on += std::abs(place - std::round(place)) < off;
  }
  return {step, static_cast<double>(on) / static_cast<double>(values.size()),
          levels.size()};
}

}  // namespace workbench
