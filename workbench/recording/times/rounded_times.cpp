#include "workbench/recording/times/rounded_times.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>

#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

constexpr double kSame = 0.01;          // of a step: intervals alike
constexpr double kFewestOfEach = 0.05;  // of all intervals
constexpr double kFewestShared = 4;
constexpr double kMostGaps = 0.05;
constexpr std::size_t kFewest = 20;  // stamps

struct Steps {
  double size = 0;    // s; 0: none
  double longer = 0;  // the longer one of both intervals, s
};

Steps steps_of(const std::vector<double>& stamps) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  double shortest = kInfinite;
  double longest = 0;
  for (std::size_t i = 1; i < stamps.size(); ++i) {
    shortest = std::min(shortest, stamps[i] - stamps[i - 1]);
    longest = std::max(longest, stamps[i] - stamps[i - 1]);
  }
  // The least that is no rounding of a stamp in seconds since 1900.
  const double tiny = std::max(1e-5, 1e-3 * shortest);
  double longer = kInfinite;
  for (std::size_t i = 1; i < stamps.size(); ++i) {
    const double interval = stamps[i] - stamps[i - 1];
    if (interval > shortest + tiny) longer = std::min(longer, interval);
  }
  if (!(longer <= longest)) return {};
  const double size = longer - shortest;
  if (std::abs(longer / size - std::round(longer / size)) > kSame) return {};
  std::size_t of_shorter = 0, of_longer = 0, gaps = 0;
  for (std::size_t i = 1; i < stamps.size(); ++i) {
    const double interval = stamps[i] - stamps[i - 1];
    if (interval < shortest + kSame * size) {
      ++of_shorter;
    } else if (interval < longer + kSame * size) {
      ++of_longer;
    } else if (interval > longer + (1 - kSame) * size) {
      ++gaps;
    } else {
      return {};
    }
  }
  const auto all = static_cast<double>(stamps.size() - 1);
  const auto fewer = static_cast<double>(std::min(of_shorter, of_longer));
  // One sample missing is no rounding; a stamp that several rows share is.
  const double fewest = shortest > 0 ? kFewestOfEach * all : kFewestShared;
  if (fewer < fewest || static_cast<double>(gaps) > kMostGaps * all) return {};
  return {size, longer};
}

// Stamps between two gaps, [first, last).
struct Stretch {
  std::size_t first;
  std::size_t last;
};

std::vector<Stretch> stretches_of(const std::vector<double>& stamps, const Steps& steps) {
  std::vector<Stretch> out = {{0, 1}};
  for (std::size_t i = 1; i < stamps.size(); ++i) {
    const bool gap = stamps[i] - stamps[i - 1] > steps.longer + steps.size / 2;
    if (gap) out.push_back({i, i});
    out.back().last = i + 1;
  }
  return out;
}

// Where stamps lie above a straight line of so many seconds a row.
struct Off {
  double least;
  double most;
};

Off off_line(const std::vector<double>& stamps, const Stretch& stretch, double period_s) {
  Off off{std::numeric_limits<double>::infinity(),
          -std::numeric_limits<double>::infinity()};
  for (std::size_t i = stretch.first; i < stretch.last; ++i) {
    const double at = stamps[i] - stamps[stretch.first] -
                      period_s * static_cast<double>(i - stretch.first);
    off.least = std::min(off.least, at);
    off.most = std::max(off.most, at);
  }
  return off;
}

// Convex in the period.
double widest(const std::vector<double>& stamps, const std::vector<Stretch>& stretches,
              double period_s) {
  double out = 0;
  for (const Stretch& stretch : stretches) {
    const Off off = off_line(stamps, stretch, period_s);
    out = std::max(out, off.most - off.least);
  }
  return out;
}

// The roundest period for which all stamps are within `most` of their line; 0: none.
double period_within(const std::vector<double>& stamps,
                     const std::vector<Stretch>& stretches, const Steps& steps,
                     double most) {
  constexpr int kHalvings = 40;
  double low = steps.longer - steps.size;
  double high = steps.longer;
  for (int i = 0; i < kHalvings; ++i) {
    const double third = (high - low) / 3;
    const bool left =
        widest(stamps, stretches, low + third) < widest(stamps, stretches, high - third);
    (left ? high : low) = left ? high - third : low + third;
  }
  const double best = (low + high) / 2;
  if (widest(stamps, stretches, best) > most) return 0;
  for (int digits = 1; digits <= 12; ++digits) {
    const double round = std::strtod(number(best, digits).c_str(), nullptr);
    if (widest(stamps, stretches, round) <= most) return round;
  }
  return best;
}

}  // namespace

std::optional<RoundedTimes> unrounded(const std::vector<double>& stamps) {
  if (stamps.size() < kFewest) return std::nullopt;
  const Steps steps = steps_of(stamps);
  if (steps.size == 0) return std::nullopt;
  const std::vector<Stretch> stretches = stretches_of(stamps, steps);
  const double most = (1 + kSame) * steps.size;
  RoundedTimes out;
  out.step = steps.size;
  out.period_s = period_within(stamps, stretches, steps, most);
  if (!(out.period_s > 0)) return std::nullopt;

  out.t = stamps;
  const double origin = stamps[0] + off_line(stamps, stretches[0], out.period_s).most;
  for (const Stretch& stretch : stretches) {
    const Off off = off_line(stamps, stretch, out.period_s);
    // On the grid of the first stretch where that is within a step of every stamp.
    double start = stamps[stretch.first] + off.most;
    const double rows = std::ceil((start - origin) / out.period_s - kSame);
    const double on_grid = origin + rows * out.period_s;
    if (on_grid <= stamps[stretch.first] + off.least + most) start = on_grid;
    for (std::size_t i = stretch.first; i < stretch.last; ++i) {
      out.t[i] = start + out.period_s * static_cast<double>(i - stretch.first);
    }
  }
  return out;
}

std::optional<ScatteredTimes> scattered_times(std::span<const double> t) {
  constexpr std::size_t kFewest = 10;
  if (t.size() < kFewest) return std::nullopt;
  const double middle = (static_cast<double>(t.size()) - 1) / 2;
  double sum = 0;
  double products = 0;
  double squares = 0;
  for (std::size_t k = 0; k < t.size(); ++k) {
    const double at = static_cast<double>(k) - middle;
    sum += t[k] - t[0];
    products += at * (t[k] - t[0]);
    squares += at * at;
  }
  const double period = products / squares;
  const double mean = sum / static_cast<double>(t.size());
  double early = 0;
  double late = 0;
  for (std::size_t k = 0; k < t.size(); ++k) {
    const double off = t[k] - t[0] - mean - period * (static_cast<double>(k) - middle);
    early = std::min(early, off);
    late = std::max(late, off);
  }
  const double most = std::max(-early, late);
  if (!(2 * most < period)) return std::nullopt;
  return ScatteredTimes{period, most};
}

}  // namespace workbench
